// Retention: the oldest runs that are over go, at the bound and not before.
#include "server/store/retention.h"

#include <SQLiteCpp/Database.h>

#include "tests/unit/server/run_store.h"

namespace race::server {
namespace {

class Retention : public StoredRuns {
 protected:
  RunId add(const std::string& status, int ticks = 1) {
    return import(*runs_, counting(std::vector<int>(static_cast<std::size_t>(ticks), 1)), status).id;
  }
  RunId add_hosted(const std::string& status) {
    const RunId id = runs_->create(run_of(counting({})), 1)->id;
    EXPECT_TRUE(runs_->set_status(id, status));
    return id;
  }
  std::size_t apply(const RetentionLimits& limits, RunId hosted = 0) {
    return apply_retention(*runs_, limits, [hosted](RunId id) { return id == hosted; }).value();
  }
  std::vector<RunId> numbers() {
    std::vector<RunId> found;
    const auto all = runs_->list(0, 100).value();
    for (const RunRecord& run : all.runs) found.push_back(run.id);
    return found;
  }
  const std::unique_ptr<Runs> runs_ = open();
};

TEST_F(Retention, RemovesTheOldestRunsBeyondTheNumber) {
  for (int i = 0; i < 3; ++i) add("ended");
  EXPECT_EQ(apply({.runs = 3}), 0u);
  add("aborted");
  EXPECT_EQ(apply({.runs = 3}), 1u);
  EXPECT_EQ(numbers(), (std::vector<RunId>{4, 3, 2}));
  EXPECT_EQ(apply({.runs = 0}), 3u);
  EXPECT_TRUE(numbers().empty());
}

TEST_F(Retention, RemovesTheOldestRunsBeyondTheirBytes) {
  for (int i = 0; i < 3; ++i) add("faulted", 5);
  const std::uint64_t each = runs_->get(1)->bytes;
  EXPECT_EQ(apply({.bytes = 3 * each}), 0u);
  EXPECT_EQ(apply({.bytes = 3 * each - 1}), 1u);
  EXPECT_EQ(numbers(), (std::vector<RunId>{3, 2}));
}

TEST_F(Retention, KeepsRunsThatAreNotOver) {
  for (const char* status : {"ready", "running", "interrupted", "ended"}) add_hosted(status);
  EXPECT_EQ(apply({.runs = 0, .bytes = 0}), 1u);
  EXPECT_EQ(numbers(), (std::vector<RunId>{3, 2, 1}));
}

TEST_F(Retention, KeepsRunsThatAreHosted) {
  for (int i = 0; i < 3; ++i) add("ended");
  EXPECT_EQ(apply({.runs = 1}, 1), 1u);
  EXPECT_EQ(numbers(), (std::vector<RunId>{3, 1}));
}

TEST_F(Retention, KeepsADamagedRunThatMayGoOn) {
  add_hosted("interrupted");
  add("ended");
  SQLite::Database(path(), SQLite::OPEN_READWRITE).exec("UPDATE run SET imported = 1 WHERE id = 1");
  EXPECT_EQ(apply({.runs = 0}), 1u);
  EXPECT_EQ(runs_->get(1).error().code, ErrorCode::corrupt);
}

TEST_F(Retention, RemovesARunThatIsDamaged) {
  add("ended");
  add("ended");
  SQLite::Database(path(), SQLite::OPEN_READWRITE).exec("UPDATE run SET steps = 7 WHERE id = 1");
  ASSERT_EQ(runs_->get(1).error().code, ErrorCode::corrupt);
  EXPECT_EQ(apply({.runs = 1}), 1u);
  EXPECT_EQ(numbers(), (std::vector<RunId>{2}));
}

}  // namespace
}  // namespace race::server
