// Services of one's own in C++ (api/cpp): what is declared, and the RSM that this comes to.
#include <gmock/gmock.h>

#include <fstream>
#include <limits>

#include "api/cpp/race_client/declaration.h"
#include "api/cpp/race_client/options.h"
#include "core/rsm/document.h"
#include "core/value/json.h"
#include "tests/unit/temporary_folder.h"

namespace race::client {
namespace {

using testing::EndsWith;
using testing::HasSubstr;

// A gripper; `line(text)` is that of what a test declares itself.
struct CppDeclaration : testing::Test {
  CppDeclaration() {
    declaration.key = declaration.type = "grip";
    declaration.place = std::source_location::current();
    declaration.events.push_back({{"moved", "number", false, std::nullopt, ""}, std::source_location::current()});
    DeclaredOperation& move = add("move");
    move.model.moves = true;
    move.busy = "Moving";
    move.model.parameters.push_back({"width", "number", "m", "", 0, 0.11, std::nullopt});
    DeclaredOperation& stop = add("stop");
    stop.model.safe = true;
    stop.stops = "Moving";
  }
  DeclaredOperation& add(std::string name, std::source_location place = std::source_location::current()) {
    DeclaredOperation& made = declaration.operations.emplace_back();
    made.model.name = std::move(name);
    made.model.error = "any";
    made.handler = [](Call&) { return Value(); };
    made.place = place;
    return made;
  }
  std::string error() {
    const auto model = model_of(declaration);
    return model ? "" : model.error();
  }
  static std::string at(const std::source_location& place) {
    return std::string(place.file_name()) + ":" + std::to_string(place.line());
  }
  Declaration declaration;
};

TEST_F(CppDeclaration, ComesToTheRsmThatAClassInPythonComesTo) {
  declaration.version = "1.2";
  const auto model = model_of(declaration);
  ASSERT_TRUE(model) << model.error();
  const auto expected = parse_json(R"json({
    "rsm": 1, "name": "grip",
    "operations": [{"name": "move", "parameters": [{"name": "width", "type": "number", "unit": "m", "min": 0.0, "max": 0.11}],
                    "error": "any", "moves": true},
                   {"name": "stop", "error": "any", "safe": true}],
    "events": [{"name": "moved", "data": "number"}],
    "states": [{"name": "Ready", "events": ["moved"]}, {"name": "Moving", "events": ["moved"]}],
    "init": "Ready",
    "transitions": [
      {"id": "move", "src": "Ready", "dst": "Moving", "operation": "move", "defer": ["move_done", "stop_Moving"]},
      {"id": "move_done", "src": "Moving", "dst": "Ready"},
      {"id": "stop_Ready", "src": "Ready", "dst": "Ready", "operation": "stop"},
      {"id": "stop_Moving", "src": "Moving", "dst": "Ready", "operation": "stop", "error": "stopped"}],
    "meta": {"version": "1.2"}})json");
  ASSERT_TRUE(expected);
  EXPECT_EQ(to_json(rsm::write_service(*model), 1), to_json(*expected, 1));
}

TEST_F(CppDeclaration, SaysWhatIsWrongAtTheLineOfTheOperation) {
  const DeclaredOperation& halt = add("halt");
  declaration.operations.back().stops = "Flying";
  EXPECT_EQ(error(), at(halt.place) + ": error: `halt` stops `Flying`, in which nothing is busy");
  declaration.operations.back().busy = "Halting";
  EXPECT_EQ(error(), at(halt.place) + ": error: `halt` is busy, and cannot stop another: have an operation for that");
  declaration.operations.back().stops.clear();
  declaration.operations.back().handler = nullptr;
  EXPECT_EQ(error(), at(halt.place) + ": error: `halt` does nothing: `does` is missing");
}

TEST_F(CppDeclaration, RefusesWhatNoRsmCanBe) {
  declaration.operations.front().model.parameters.front().max = std::numeric_limits<double>::infinity();
  EXPECT_THAT(error(), EndsWith("error: the declaration of `grip` has a number that is not finite"));
  declaration.operations.front().model.parameters.front().max = 1;
  declaration.operations.front().model.doc = "\xFF";
  EXPECT_THAT(error(), HasSubstr("has a text that is not UTF-8"));
  declaration.operations.front().model.doc.clear();
  declaration.operations.front().model.result = "metres";
  EXPECT_THAT(error(), HasSubstr("there is no type \"metres\""));
  declaration.operations.front().model.result = Value();
  const DeclaredOperation& again = add("move");
  EXPECT_THAT(error(), HasSubstr("`move` is declared twice"));
  EXPECT_THAT(error(), Not(HasSubstr(at(again.place)))) << "the first has the name";
}

TEST_F(CppDeclaration, HasAKeyOf64LettersAtMost) {
  declaration.key = std::string(64, 'k');
  EXPECT_EQ(error(), "");
  for (const char* key : {"", "a b", "7"}) {
    declaration.key = key;
    EXPECT_THAT(error(), HasSubstr("a key or type has letters")) << key;
  }
  declaration.key = std::string(65, 'k');
  EXPECT_THAT(error(), testing::StartsWith(at(declaration.place) + ": error: "));
}

TEST_F(CppDeclaration, KeepsToAnRsmOfOnesOwn) {
  declaration.rsm_text = R"({"rsm": 1, "name": "grip", "operations": [{"name": "move"}], "events": []})";
  EXPECT_EQ(error(), at(declaration.operations.back().place) + ": error: the RSM has no operation `stop`");
  declaration.operations.pop_back();
  EXPECT_EQ(error(), "");
  declaration.operations.clear();
  EXPECT_THAT(error(), EndsWith("the RSM has the operation `move`, and the service does not"));
  declaration.rsm_text = "{";
  EXPECT_THAT(error(), HasSubstr("not JSON"));
}

TEST_F(CppDeclaration, KnowsWhereANameIsDeclared) {
  const DeclaredOperation& halt = add("halt");
  EXPECT_EQ(place_of_text(declaration, "halt", "result of `halt`"), at(halt.place));
  EXPECT_EQ(place_of_text(declaration, "", "event `moved`: expected"), at(declaration.events.front().place));
  EXPECT_EQ(place_of_text(declaration, "", "`nothing` in `Moving`"), at(declaration.operations.front().place));
  EXPECT_EQ(place_of_text(declaration, "", "an `unfinished"), at(declaration.place));
}

TEST_F(CppDeclaration, NamesTheLineOfAFile) {
  const TemporaryFolder folder;
  const std::string path = folder.file("grip.rsm.json");
  read_rsm_file(declaration, path);
  EXPECT_EQ(error(), path + ":1: error: the file cannot be read");
  std::ofstream(path) << "{\"rsm\": 1, \"name\": \"grip\",\n \"operations\": [{\"name\": \"move\"},\n"
                         "                {\"name\": \"stop\"}, {\"name\": \"hop\"}], \"events\": []}\n";
  read_rsm_file(declaration, path);
  EXPECT_EQ(error(), path + ":3: error: the RSM has the operation `hop`, and the service does not");
  EXPECT_EQ(place_of_text(declaration, "move", ""), path + ":2");
}

TEST(CppOptions, AreThoseOfTheCommandLine) {
  const auto options = read_options({"--server", "http://there:81", "--token-file=key"});
  ASSERT_TRUE(options);
  EXPECT_EQ(options->address.host, "there");
  EXPECT_EQ(options->token_file, "key");
  const auto code = [](const std::vector<std::string>& arguments) {
    const auto read = read_options(arguments);
    return read ? "" : std::string(name(read.error().code));
  };
  EXPECT_EQ(code({"--sever"}), "syntax");
  EXPECT_EQ(code({"--server"}), "missing");
  EXPECT_EQ(code({"--server", "there"}), "syntax");
  EXPECT_EQ(code({"--server=https://there"}), "not_accepted");
}

TEST(CppOptions, ReadATokenThatFitsAHeader) {
  const TemporaryFolder folder;
  const std::string path = folder.file("token");
  EXPECT_EQ(find_token(path).error().code, ErrorCode::io);
  std::ofstream(path) << " race_x-1\n";
  EXPECT_EQ(find_token(path).value(), "race_x-1");
  std::ofstream(path) << "race_x\r\nHost: there\n";
  EXPECT_EQ(find_token(path).error().code, ErrorCode::not_accepted);
  std::ofstream(path) << "\n";
  EXPECT_EQ(find_token(path).error().code, ErrorCode::not_accepted);
}

}  // namespace
}  // namespace race::client
