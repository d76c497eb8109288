#include "services/database/database.h"

#include <SQLiteCpp/Database.h>
#include <gmock/gmock.h>

#include "core/value/json.h"
#include "tests/unit/services/host/bench.h"
#include "tests/unit/temporary_folder.h"

namespace race::database {
namespace {

using services::Bench;
using testing::ElementsAre;
using testing::IsEmpty;

struct DatabaseTest : testing::Test {
  DatabaseTest() { bench.add<Database>("db", Store::open(":memory:").value()); }
  Bench bench;
};

TEST_F(DatabaseTest, GivesBackWhatWasAdded) {
  const std::string pose = R"({"position":[0.4,0.0,0.1],"orientation":[0.0,1.0,0.0,0.0]})";
  bench.call("db", "add", {"part", parse_json(pose).value()});
  bench.call("db", "get", {"part"});
  EXPECT_THAT(bench.responses(), ElementsAre("db.add -> \"part\"", "db.get -> " + pose));
  EXPECT_THAT(bench.violations("db"), IsEmpty());
}

TEST_F(DatabaseTest, KeepsEveryKindOfValueApart) {
  for (const char* json : {"null", "true", "1", "1.0", "9007199254740993", "\"1\"", "[]", "{}", R"([{"a":[1,2.5]}])"}) {
    bench.call("db", "add", {"x", parse_json(json).value()});
    bench.call("db", "get", {"x"});
    EXPECT_EQ(bench.responses().back(), std::string("db.get -> ") + json);
  }
}

TEST_F(DatabaseTest, AddReplaces) {
  bench.call("db", "add", {"x", 1});
  bench.call("db", "add", {}, {{"value", 2}, {"key", "x"}});
  bench.call("db", "get", {"x"});
  EXPECT_EQ(bench.responses().back(), "db.get -> 2");
}

TEST_F(DatabaseTest, AnUnknownKeyIsNotFound) {
  bench.call("db", "get", {"nothing"});
  bench.call("db", "remove", {"nothing"});
  EXPECT_THAT(bench.responses(), ElementsAre("db.get !> not_found", "db.remove !> not_found"));
  EXPECT_THAT(bench.violations("db"), IsEmpty());
}

TEST_F(DatabaseTest, ARemovedKeyIsGone) {
  bench.call("db", "add", {"x", 1});
  bench.call("db", "remove", {"x"});
  bench.call("db", "get", {"x"});
  EXPECT_THAT(bench.responses(), ElementsAre("db.add -> \"x\"", "db.remove -> \"x\"", "db.get !> not_found"));
}

TEST_F(DatabaseTest, ListsKeysByPrefix) {
  for (const char* key : {"pose.b", "o_t_c", "pose.a", "pose"}) bench.call("db", "add", {key, 0});
  bench.call("db", "list", {"pose."});
  EXPECT_EQ(bench.responses().back(), R"(db.list -> ["pose.a","pose.b"])");
  bench.call("db", "list");
  EXPECT_EQ(bench.responses().back(), R"(db.list -> ["o_t_c","pose","pose.a","pose.b"])");
}

TEST_F(DatabaseTest, AnswersWhateverItIsAskedWith) {
  bench.call("db", "get", {5});
  bench.call("db", "add", {"x"});
  bench.call("db", "add", {"", 1});
  bench.call("db", "add", {std::string(Store::kKeyBytes + 1, 'k'), 1});
  Value deep = 0;
  for (int i = 0; i < 100; ++i) deep = List{deep};
  bench.call("db", "add", {"deep", deep});
  bench.call("db", "add", {"large", std::string(Store::kValueBytes, 'x')});
  EXPECT_THAT(bench.responses(), ElementsAre("db.get !> type", "db.add !> missing", "db.add !> out_of_range",
                                             "db.add !> out_of_range", "db.add !> too_deep", "db.add !> too_large"));
}

TEST_F(DatabaseTest, KeysAreTextNotSql) {
  const std::string key = "'; DROP TABLE record; --%_";
  bench.call("db", "add", {key, 1});
  bench.call("db", "list", {"'"});
  EXPECT_EQ(bench.responses().back(), "db.list -> " + to_json(List{key}));
}

TEST_F(DatabaseTest, IsAcceptedWhileOtherCallsWait) {
  for (int i = 0; i < 3; ++i) bench.host.call({"core" + std::to_string(i), 1}, "db", "add", {"x", i}, {});
  bench.queue.run();
  EXPECT_EQ(bench.responses().size(), 3U);
  EXPECT_EQ(bench.deliveries[2].caller.core, "core2");
  EXPECT_THAT(bench.violations("db"), IsEmpty());
}

TEST(DatabaseFile, SurvivesARestart) {
  const TemporaryFolder folder;
  const auto path = folder.path / "race.sqlite";
  {
    Bench first;
    first.add<Database>("db", Store::open(path).value());
    first.call("db", "add", {"part", 0.25});
  }
  Bench second;
  second.add<Database>("db", Store::open(path).value());
  second.call("db", "get", {"part"});
  EXPECT_THAT(second.responses(), ElementsAre("db.get -> 0.25"));
}

TEST(DatabaseFile, ThatCannotBeOpenedIsAnError) {
  const auto store = Store::open("/nowhere/at/all.sqlite");
  ASSERT_FALSE(store);
  EXPECT_EQ(store.error().code, ErrorCode::storage);
  EXPECT_EQ(store.error().path, "/nowhere/at/all.sqlite");
}

TEST(DatabaseFile, ThatHasLostItsTableAnswersIo) {
  const TemporaryFolder folder;
  const auto path = folder.path / "race.sqlite";
  Bench bench;
  bench.add<Database>("db", Store::open(path).value());
  SQLite::Database(path.string(), SQLite::OPEN_READWRITE).exec("DROP TABLE record");
  bench.call("db", "get", {"x"});
  bench.call("db", "add", {"x", 1});
  bench.call("db", "remove", {"x"});
  bench.call("db", "list");
  EXPECT_THAT(bench.responses(), ElementsAre("db.get !> io", "db.add !> io", "db.remove !> io", "db.list !> io"));
  EXPECT_EQ(bench.deliveries.front().data,
            Value(Dict{{"code", "io"}, {"message", "cannot read `x`: no such table: record"}}));
}

TEST(DamagedDatabase, NamesWhatIsDamagedInTheAnswerAndOnceInTheLog) {
  const TemporaryFolder folder;
  const std::string path = folder.file("database.sqlite");
  {
    auto store = Store::open(path).value();
    for (const char* key : {"a", "b"}) ASSERT_TRUE(store.put(key, 1));
  }
  SQLite::Database(path, SQLite::OPEN_READWRITE).exec("UPDATE record SET value = '2' WHERE key = 'b'");
  Bench bench;
  bench.add<Database>("db", Store::open(path).value());
  for (const char* key : {"a", "b", "a", "b"}) bench.call("db", "get", {key});
  EXPECT_THAT(bench.responses(), ElementsAre("db.get -> 1", "db.get !> corrupt", "db.get -> 1", "db.get !> corrupt"));
  EXPECT_THAT(bench.log, ElementsAre("the value of `b` is damaged"));
}

}  // namespace
}  // namespace race::database
