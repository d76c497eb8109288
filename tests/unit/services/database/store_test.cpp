// What the store keeps when the disk is full, fails, loses power or changes a bit.
#include "services/database/store.h"

#include <SQLiteCpp/Database.h>
#include <gmock/gmock.h>

#include <fstream>
#include <map>
#include <random>

#include "core/value/json.h"
#include "tests/unit/services/sqlite/faulty_vfs.h"
#include "tests/unit/setting.h"
#include "tests/unit/temporary_folder.h"

namespace race::database {
namespace {

using sqlite::FaultyVfs;
using testing::ElementsAre;

using Content = std::map<std::string, std::string>;  // key -> JSON

struct StoreTest : testing::Test {
  TemporaryFolder folder, after;
  const std::string path = folder.file("database.sqlite"), path_after = after.file("database.sqlite");

  void change_file(const char* sql) const { SQLite::Database(path, SQLite::OPEN_READWRITE).exec(sql); }
};

/// All that a store says it has.
Content content_of(Store& store) {
  Content content;
  const auto keys = store.keys("").value();
  for (const std::string& key : keys) content[key] = to_json(store.get(key).value());
  return content;
}

struct Step {
  std::string key;
  std::optional<std::string> value;  // none: the key is removed
};

/// Changes of a few keys: values of some pages, others of some bytes.
std::vector<Step> make_steps(int count) {
  std::mt19937 random(7);
  std::vector<Step> steps;
  for (int i = 0; i < count; ++i) {
    const std::string key = "key" + std::to_string(random() % 6);
    if (random() % 5 == 0)
      steps.push_back({key, {}});
    else
      steps.push_back({key, std::string(random() % 3 == 0 ? 9000 : 20, static_cast<char>('a' + i % 26))});
  }
  return steps;
}

Expected<void> apply(Store& store, const Step& step) {
  return step.value ? store.put(step.key, *step.value) : store.remove(step.key);
}

void apply(Content& content, const Step& step) {
  if (step.value)
    content[step.key] = to_json(*step.value);
  else
    content.erase(step.key);
}

TEST_F(StoreTest, KeepsEveryChangeAfterALossOfPowerAtAnyOperation) {
  FaultyVfs vfs;
  Content answered, with_next;
  vfs.before_each([&](std::uint64_t operation) {
    for (const double kept : {0.0, 0.5, 1.0}) {
      vfs.lose_power(folder.path, after.path, kept, operation);
      auto store = Store::open(path_after);
      ASSERT_TRUE(store) << to_string(store.error()) << ", operation " << operation;
      EXPECT_THAT(content_of(*store), testing::AnyOf(answered, with_next))
          << "operation " << operation << ", kept " << kept;
    }
  });
  auto store = Store::open(path).value();
  for (const Step& step : make_steps(25)) {
    with_next = answered;
    apply(with_next, step);
    const auto done = apply(store, step);
    EXPECT_EQ(done.has_value(), with_next != answered || step.value) << step.key;
    answered = with_next;
  }
  EXPECT_GT(vfs.operations(), 100U);
}

TEST_F(StoreTest, AnswersStorageWhenTheDiskFailsAndWorksAgainAfterwards) {
  const std::vector<Step> steps = make_steps(8);
  for (const auto fault : {FaultyVfs::Fault::full, FaultyVfs::Fault::io})
    for (const bool for_ever : {false, true}) {
      bool failed = true;
      for (std::uint64_t nth = 1; failed; ++nth) {
        SCOPED_TRACE("operation " + std::to_string(nth) + (for_ever ? ", for ever" : ", once"));
        for (const char* suffix : {"", "-wal", "-shm"}) std::filesystem::remove(path + suffix);
        FaultyVfs vfs;
        auto store = Store::open(path).value();
        vfs.fail_at(nth, fault, for_ever);
        Content answered;
        for (const Step& step : steps) {
          const auto done = apply(store, step);
          if (done) apply(answered, step);
          const auto code = done ? ErrorCode::storage : done.error().code;
          EXPECT_TRUE(code == ErrorCode::storage || code == ErrorCode::not_found) << done.error().message;
        }
        failed = vfs.has_failed();
        vfs.repair();
        EXPECT_EQ(content_of(store), answered);
        EXPECT_TRUE(store.put("again", true));
        EXPECT_TRUE(Store::open(path)) << "as another process sees it";
      }
    }
}

TEST_F(StoreTest, IsNotOpenedWhileTheDiskFails) {
  { ASSERT_TRUE(Store::open(path).value().put("x", 1)); }
  bool failed = true;
  for (std::uint64_t nth = 1; failed; ++nth) {
    FaultyVfs vfs;
    vfs.fail_at(nth, FaultyVfs::Fault::io, true);
    const auto store = Store::open(path);
    failed = vfs.has_failed();
    ASSERT_EQ(store.has_value(), !failed) << "operation " << nth;
    if (failed) {
      EXPECT_EQ(store.error().code, ErrorCode::storage) << store.error().message;
    }
  }
}

TEST_F(StoreTest, TakesOverAFileOfTheFirstVersion) {
  SQLite::Database(path, SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE)
      .exec(
          "PRAGMA journal_mode = WAL; CREATE TABLE entry (key TEXT PRIMARY KEY, value TEXT NOT NULL) WITHOUT ROWID;"
          "INSERT INTO entry VALUES ('pose', '{\"x\":0.5}'), ('n', '3')");
  for (int i = 0; i < 2; ++i) {
    auto store = Store::open(path);
    ASSERT_TRUE(store) << store.error().message;
    EXPECT_EQ(content_of(*store), (Content{{"n", "3"}, {"pose", R"({"x":0.5})"}}));
  }
}

TEST_F(StoreTest, OfANewerVersionIsRefused) {
  { ASSERT_TRUE(Store::open(path)); }
  change_file("PRAGMA user_version = 3");
  const auto store = Store::open(path);
  ASSERT_FALSE(store);
  EXPECT_EQ(store.error().code, ErrorCode::version);
}

TEST_F(StoreTest, ReplacesAllValuesOrNone) {
  Dict values{{"b", 2}, {"c", 3}};
  {
    auto store = Store::open(path).value();
    ASSERT_TRUE(store.put("a", 1) && store.put("b", 1));
    ASSERT_TRUE(store.replace_all(values));
    EXPECT_EQ(content_of(store), (Content{{"b", "2"}, {"c", "3"}}));
    values.set("", 4);
    EXPECT_EQ(store.replace_all(values).error().code, ErrorCode::out_of_range);
  }
  auto again = Store::open(path);
  ASSERT_TRUE(again) << to_string(again.error());
  EXPECT_EQ(content_of(*again), (Content{{"b", "2"}, {"c", "3"}}));
}

TEST_F(StoreTest, TakesNoMoreKeysThanItMay) {
  for (int i = 0; i < 2; ++i) {
    auto store = Store::open(path, {.keys = 2}).value();
    for (const char* key : {"a", "b"}) EXPECT_TRUE(store.put(key, i)) << key;
    EXPECT_EQ(store.put("c", i).error().code, ErrorCode::too_large);
    EXPECT_THAT(store.keys("").value(), ElementsAre("a", "b"));
  }
  auto store = Store::open(path, {.keys = 2}).value();
  EXPECT_TRUE(store.remove("a"));
  EXPECT_TRUE(store.put("c", 3));
}

TEST_F(StoreTest, TakesNoMoreBytesThanItMay) {
  constexpr std::uint64_t kBytes = 500'000;
  auto store = Store::open(path, {.bytes = kBytes}).value();
  const Value large = std::string(50'000, 'x');
  int stored = 0;
  Expected<void> put;
  while ((put = store.put("large" + std::to_string(stored), large)) && stored < 100) ++stored;
  ASSERT_FALSE(put);
  EXPECT_EQ(put.error().code, ErrorCode::too_large);
  EXPECT_THAT(stored, testing::AllOf(testing::Ge(8), testing::Le(9)));
  EXPECT_TRUE(store.put("large0", large)) << "makes it no larger";
  EXPECT_EQ(store.put("large0", std::string(100'000, 'x')).error().code, ErrorCode::too_large);
  EXPECT_EQ(store.get("large0").value(), large) << "the old value stays";
  EXPECT_TRUE(store.remove("large1"));
  EXPECT_TRUE(store.put("other", large));
}

TEST_F(StoreTest, ThatHasMoreThanItMayIsReadAndCanBecomeSmaller) {
  for (const char* key : {"a", "b"}) ASSERT_TRUE(Store::open(path).value().put(key, std::string(50'000, 'x')));
  auto store = Store::open(path, {.keys = 1, .bytes = 10'000}).value();
  EXPECT_THAT(store.keys("").value(), ElementsAre("a", "b"));
  EXPECT_TRUE(store.put("a", 1));
  EXPECT_TRUE(store.remove("b"));
}

TEST_F(StoreTest, ListsNoMoreThanAValueMayBe) {
  auto store = Store::open(":memory:").value();
  for (int i = 0; i < 17'000; ++i) {
    const std::string number = std::to_string(10'000 + i);
    ASSERT_TRUE(store.put(std::string(Store::kKeyBytes - number.size(), 'k') + number, i));
  }
  EXPECT_EQ(store.keys("k").error().code, ErrorCode::too_large);
  EXPECT_TRUE(store.keys("x"));
}

struct DamagedStore : StoreTest {
  DamagedStore() {
    auto store = Store::open(path).value();
    for (const char* key : {"a", "b", "c"}) EXPECT_TRUE(store.put(key, key));
  }
};

TEST_F(DamagedStore, NamesADamagedValueAndGoesOnWithOthers) {
  for (const char* damage : {"value = '\"B\"'", "digest = zeroblob(32)", "digest = x'00'"}) {
    change_file((std::string("UPDATE record SET ") + damage + " WHERE key = 'b'").c_str());
    auto store = Store::open(path);
    ASSERT_TRUE(store) << store.error().message;
    const auto got = store->get("b");
    ASSERT_FALSE(got);
    EXPECT_EQ(got.error(), (Error{ErrorCode::corrupt, "the value of `b` is damaged", "b"}));
    EXPECT_EQ(store->get("a").value(), Value("a"));
    EXPECT_EQ(store->keys("").error().message, "1 damaged rows are in the database: `b`");
    EXPECT_EQ(store->get("d").error().code, ErrorCode::corrupt) << "b may have been d";
    EXPECT_TRUE(store->put("d", 1));
    EXPECT_TRUE(store->remove("d"));
    ASSERT_TRUE(store->put("b", "b")) << "repaired";
    EXPECT_THAT(store->keys("").value(), ElementsAre("a", "b", "c"));
    EXPECT_EQ(store->get("d").error().code, ErrorCode::not_found);
  }
}

TEST_F(DamagedStore, CanRemoveTheDamagedRow) {
  change_file("UPDATE record SET digest = zeroblob(32) WHERE key = 'b'");
  { ASSERT_TRUE(Store::open(path).value().remove("b")); }
  EXPECT_THAT(Store::open(path).value().keys("").value(), ElementsAre("a", "c"));
}

TEST_F(DamagedStore, WithALostRowIsNotOpened) {
  change_file("DELETE FROM record WHERE key = 'b'");
  const auto store = Store::open(path);
  ASSERT_FALSE(store);
  EXPECT_EQ(store.error().code, ErrorCode::corrupt);
  EXPECT_EQ(store.error().path, path);
}

TEST_F(DamagedStore, WithAnotherSchemaIsNotOpened) {
  change_file("DROP TABLE record; CREATE TABLE record (key INT PRIMARY KEY, value TEXT, digest BLOB) WITHOUT ROWID");
  const auto store = Store::open(path);
  ASSERT_FALSE(store);
  EXPECT_EQ(store.error().code, ErrorCode::corrupt);
}

std::string read_whole(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// What a flipped bit did: an error said so, or nothing was lost.
enum class Effect : std::uint8_t { none, named, silent };

Effect effect_on(const std::string& path, const Content& content) {
  auto store = Store::open(path);
  if (!store) return Effect::named;
  const auto keys = store->keys("");
  bool named = !keys;
  std::vector<std::string> all;
  for (const auto& [key, json] : content) all.push_back(key);
  if (keys && *keys != all) return Effect::silent;
  for (const auto& [key, json] : content) {
    const auto value = store->get(key);
    if (value ? to_json(*value) != json : value.error().code == ErrorCode::not_found) return Effect::silent;
    named = named || !value;
  }
  return named ? Effect::named : Effect::none;
}

struct FlippedBit : StoreTest {
  Content content;

  void fill() {
    auto store = Store::open(path).value();
    for (const Step& step : make_steps(40))
      if (apply(store, step)) apply(content, step);
    for (int i = 0; i < 60; ++i) {
      const Step step{"pose." + std::to_string(i), std::string(100, 'p')};
      ASSERT_TRUE(apply(store, step));
      apply(content, step);
    }
  }
};

TEST_F(FlippedBit, IsNamedOrHarmless) {
  const FaultyVfs vfs;  // which spares the disk
  fill();
  const std::uint64_t seed = setting("RACE_SEED", 1);
  std::mt19937_64 random(seed);
  const std::string file = read_whole(path);
  ASSERT_FALSE(std::filesystem::exists(path + "-wal")) << "the last connection has copied it into the file";
  std::map<Effect, int> effects;
  constexpr int kBits = 2000;
  for (int i = 0; i < kBits; ++i) {
    // The first page has the header and the schema; the others are alike.
    const std::size_t byte = random() % (i % 4 == 0 ? 1024 : file.size());
    std::string flipped = file;
    flipped[byte] = static_cast<char>(flipped[byte] ^ (1 << random() % 8));
    for (const char* suffix : {"-wal", "-shm"}) std::filesystem::remove(path_after + suffix);
    std::ofstream(path_after, std::ios::binary) << flipped;
    const Effect effect = effect_on(path_after, content);
    ++effects[effect];
    EXPECT_NE(effect, Effect::silent) << "byte " << byte << " of " << file.size() << ", seed " << seed;
  }
  std::printf("%d bits of %zu bytes, seed %lu: %d named, %d without effect\n", kBits, file.size(), seed,
              effects[Effect::named], effects[Effect::none]);
  EXPECT_GT(effects[Effect::named], kBits / 4);
}

}  // namespace
}  // namespace race::database
