#include "server/cell/cell_file.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "core/value/json.h"
#include "server/cell/cell.h"
#include "server/cell/component_groups.h"
#include "tests/unit/temporary_folder.h"

namespace race::server {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

constexpr const char* kDemo = RACE_SOURCE_DIR "/deploy/demo";

std::string text_of(const std::string& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

struct Silent final : services::HostObserver {
  void delivered(const services::Delivery&) override {}
  void changed(const services::ServiceStatus&) override {}
  void logged(services::Time, const std::string&, const std::string&) override {}
};

struct CellFileTest : testing::Test {
  void write(const std::string& name, const std::string& text) { std::ofstream(folder.file(name)) << text; }
  // "field: code" of each error of this cell.json.
  std::vector<std::string> errors(const std::string& text) {
    write("cell.json", text);
    std::vector<std::string> found;
    const auto cell = read_cell(folder.path.string());
    if (cell) return found;
    for (const Error& error : cell.error()) {
      const std::string file = folder.file("cell.json");
      EXPECT_THAT(error.path, StartsWith(file));
      const std::string field = error.path.size() > file.size() ? error.path.substr(file.size() + 2) : "";
      found.push_back(field + ": " + std::string(name(error.code)));
    }
    return found;
  }
  TemporaryFolder folder;
};

std::vector<std::string> keys(const CellFile& cell) {
  std::vector<std::string> all;
  for (const CellFile::Service& service : cell.services) all.push_back(service.key + ": " + service.type);
  return all;
}

std::vector<std::string> hosted(const std::string& folder) {
  Silent observer;
  const auto cell = Cell::create({.folder = folder, .database = ":memory:", .own_threads = false}, observer).value();
  std::vector<std::string> all;
  for (const services::ServiceStatus& service : cell->host().services())
    all.push_back(service.key + ": " + service.type);
  cell->stop();
  return all;
}

TEST_F(CellFileTest, TheDemoIsWhatItsFilesMakeWithoutOne) {
  const auto demo = read_cell(kDemo);
  ASSERT_TRUE(demo) << to_string(demo.error().front());
  const auto usual = read_cell("");
  ASSERT_TRUE(usual);
  EXPECT_EQ(keys(*demo), keys(*usual));
  EXPECT_THAT(demo->expects, IsEmpty());
  EXPECT_FALSE(demo->accounts);
  std::filesystem::copy(kDemo, folder.file("demo"), std::filesystem::copy_options::recursive);
  std::filesystem::remove(folder.file("demo") + "/cell.json");
  EXPECT_EQ(hosted(kDemo), hosted(folder.file("demo")));
  EXPECT_EQ(hosted(kDemo).size(), 6U) << "display and audio need screens";
}

TEST_F(CellFileTest, SaysWhichServicesThereAreAndByWhichKeys) {
  write("cell.json", R"({"cell": 1, "services": {"timer": "timer", "memory": "database"}, "database": "values.json"})");
  write("values.json", R"({"a": 1})");
  EXPECT_THAT(hosted(folder.path.string()), ElementsAre("timer: timer", "memory: database"));
  EXPECT_THAT(errors(R"({"cell": 1, "services": {"clock": "timer"}})"), ElementsAre("services/clock: name"));
}

TEST_F(CellFileTest, ExpectsServicesWithTheirRsm) {
  write("lamp.rsm.json", R"({"rsm": 1, "name": "lamp", "operations": [{"name": "on"}], "events": []})");
  write("cell.json", R"({"cell": 1, "services": {}, "expects": {"lamp": {"type": "lamp", "rsm": "lamp.rsm.json"}},
                         "offers": {"accounts": ["workshop"]}})");
  const auto cell = read_cell(folder.path.string());
  ASSERT_TRUE(cell) << to_string(cell.error().front());
  ASSERT_EQ(cell->expects.size(), 1U);
  EXPECT_EQ(cell->expects[0].model.operations.front().name, "on");
  EXPECT_EQ(cell->accounts, std::set<std::string>{"workshop"});
  Silent observer;
  for (const bool can_come : {true, false}) {
    const auto made =
        Cell::create({.folder = folder.path.string(), .database = ":memory:", .own_services = can_come}, observer)
            .value();
    EXPECT_FALSE(made->host().service("lamp")->available);
    EXPECT_EQ(made->host().models().at("lamp").operations.front().name, "on") << "tasks are checked against it";
    made->stop();
  }
}

TEST_F(CellFileTest, EverythingWrongIsNamed) {
  EXPECT_THAT(errors("{"), ElementsAre(": json"));
  EXPECT_THAT(errors("[]"), ElementsAre(": type"));
  EXPECT_THAT(errors("{}"), ElementsAre("cell: missing", "services: missing"));
  EXPECT_THAT(errors(R"({"cell": 2, "services": [], "scene": 5, "parts": "../parts.json", "robots": 1})"),
              ElementsAre("cell: version", "scene: type", "parts: name", "services: type", "robots: unknown_field"));
  EXPECT_THAT(errors(R"({"cell": 1, "services": {"a b": "robot", "r": "rowboat", "q": "robot", "t": 1}})"),
              ElementsAre("services: name", "services/r: not_found", "services/q: duplicate", "services/t: type"));
  EXPECT_THAT(errors(R"({"cell": 1, "services": {"db": "database"},
                         "expects": {"db": {"type": "x", "rsm": "none.json"}, "b": {"rsm": "broken.json"}, "c": 1},
                         "offers": {"accounts": 1}})"),
              ElementsAre("expects/db: duplicate", "expects/db/rsm: io", "expects/b/type: missing", "expects/c: type",
                          "offers/accounts: type"));
  write("broken.json", R"({"rsm": 1, "name": "b", "operations": [{"name": "on"}], "events": [], "init": "Nowhere"})");
  EXPECT_THAT(errors(R"({"cell": 1, "services": {}, "expects": {"b": {"type": "b", "rsm": "broken.json"}}})"),
              ElementsAre("expects/b/rsm: reference"));
}

TEST_F(CellFileTest, AServiceThatLacksItsFilesIsAnError) {
  const auto refusal = [&](const std::string& text) {
    write("cell.json", text);
    Silent observer;
    const auto cell = Cell::create({.folder = folder.path.string(), .database = ":memory:"}, observer);
    return cell ? "none" : to_string(cell.error().front());
  };
  EXPECT_THAT(refusal(R"({"cell": 1, "services": {"robot": "robot"}})"),
              HasSubstr("cell.json: services/robot: missing: needs a scene"));
  EXPECT_THAT(refusal(R"({"cell": 1, "services": {"robot": "robot"}, "scene": "none.json"})"),
              HasSubstr("none.json: io"));
  EXPECT_THAT(refusal(R"({"cell": 1, "services": {"db": "database"}, "database": "none.json"})"),
              HasSubstr("none.json: io"));
}

TEST_F(CellFileTest, ExpectsABoundedNumber) {
  write("lamp.rsm.json", R"({"rsm": 1, "name": "lamp", "operations": [{"name": "on"}], "events": []})");
  const auto expecting = [&](std::size_t number) {
    Dict expects;
    for (std::size_t i = 0; i < number; ++i)
      expects.set("s" + std::to_string(i), Dict{{"type", "lamp"}, {"rsm", "lamp.rsm.json"}});
    return errors(to_json(Dict{{"cell", 1}, {"services", Dict{}}, {"expects", std::move(expects)}}));
  };
  EXPECT_THAT(expecting(remote::OwnServices::kMost), IsEmpty());
  EXPECT_THAT(expecting(remote::OwnServices::kMost + 1), ElementsAre("expects: too_large"));
}

TEST(CellSchema, NamesTheTypesThatTheProgramHas) {
  const Value schema = parse_json(text_of(RACE_SOURCE_DIR "/api/schemas/cell.json")).value();
  const Value* types = schema.find("properties")->find("services")->find("additionalProperties")->find("enum");
  const CellFile usual = read_cell("").value();
  ASSERT_EQ(types->as_list().size(), usual.services.size());
  for (const Value& type : types->as_list()) EXPECT_TRUE(is_known_type(type.as_string())) << type.as_string();
  for (const ComponentGroup& group : component_groups())
    for (const ComponentGroup::Service& service : group.services) EXPECT_TRUE(is_known_type(service.type));
}

}  // namespace
}  // namespace race::server
