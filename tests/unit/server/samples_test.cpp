// Samples of the cell: kept in order, never more than their bound.
#include "server/store/samples.h"

#include <SQLiteCpp/Database.h>

#include "tests/unit/server/run_store.h"

namespace race::server {
namespace {

Sample sample(int number) {
  Value pose = Dict{{"time", 0.2 * number}, {"joints", Dict()}, {"bodies", Dict()}};
  return {static_cast<std::uint64_t>(number), pose.freeze()};
}

class StoredSamples : public StoredRuns {
 protected:
  StoredSamples() { runs_->create(run_of(counting({})), 1).value(); }
  void append(int from, int to, RunId run = 1) {
    std::vector<Sample> samples;
    for (int i = from; i < to; ++i) samples.push_back(sample(i));
    ASSERT_TRUE(samples_->append(run, samples));
  }
  std::vector<std::uint64_t> steps(RunId run = 1) {
    std::vector<std::uint64_t> found;
    const auto samples = samples_->read(run).value();
    for (const Sample& each : samples) found.push_back(each.step);
    return found;
  }

  const std::unique_ptr<Runs> runs_ = open();
  const std::unique_ptr<Samples> samples_ = Samples::open(path()).value();
};

TEST_F(StoredSamples, AreKeptInOrderOverRestarts) {
  append(0, 2);
  append(2, 3);
  EXPECT_EQ(steps(), (std::vector<std::uint64_t>{0, 1, 2}));
  EXPECT_EQ(Samples::open(path()).value()->read(1)->at(2).pose, sample(2).pose);
}

TEST_F(StoredSamples, AreThinnedOutAtTheirBound) {
  append(0, 2000);
  EXPECT_EQ(steps().size(), 2000u);
  append(2000, 2001);
  const auto thinned = steps();
  ASSERT_EQ(thinned.size(), 1001u);
  for (std::size_t i = 0; i < thinned.size(); ++i) ASSERT_EQ(thinned[i], 2 * i);
  append(2001, 3998);
  EXPECT_EQ(steps().size(), 1999u);
  append(3998, 20000);
  const auto late = steps();
  EXPECT_LE(late.size(), Samples::kMost);
  EXPECT_GE(late.size(), Samples::kMost / 2);
  for (std::size_t i = 1; i < late.size(); ++i) ASSERT_EQ(late[i] - late[i - 1], 16u);
}

TEST_F(StoredSamples, CountInTheSizeOfARunAndGoWithIt) {
  ASSERT_TRUE(runs_->set_status(1, "aborted"));
  const std::uint64_t before = runs_->sizes()->at(0).second;
  append(0, 10);
  EXPECT_GT(runs_->sizes()->at(0).second, before + 10 * 30);
  ASSERT_TRUE(runs_->remove(1));
  EXPECT_TRUE(steps().empty());
}

TEST_F(StoredSamples, OfARunThatIsGoneAreNotKept) {
  append(0, 3, 7);
  EXPECT_TRUE(steps(7).empty());
}

TEST_F(StoredSamples, AreNamedIfTheyAreDamaged) {
  append(0, 3);
  SQLite::Database(path(), SQLite::OPEN_READWRITE).exec("UPDATE sample SET step = 9 WHERE number = 1");
  const auto read = samples_->read(1);
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().code, ErrorCode::corrupt);
  EXPECT_EQ(read.error().path, "runs/1/samples/1");
}

}  // namespace
}  // namespace race::server
