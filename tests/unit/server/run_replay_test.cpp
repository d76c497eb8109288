// What is recomputed of stored runs: derivations and comparisons, each bounded.
#include "server/runs/run_replay.h"

#include "tests/unit/server/run_store.h"

namespace race::server {
namespace {

class RunReplay : public StoredRuns {
 protected:
  RunId add(const std::vector<int>& ticks) { return import(*runs_, counting(ticks)).id; }
  const std::unique_ptr<Runs> runs_ = open();
};

std::int64_t number(const Value& json, std::string_view key) { return json.find(key)->as_integer(); }

TEST_F(RunReplay, DerivesAtMostAHundredSteps) {
  const RunId id = add(std::vector<int>(120, 0));
  EXPECT_EQ(run_derivations(*runs_, id, 1, 100)->find("steps")->as_list().size(), 100u);
  EXPECT_EQ(run_derivations(*runs_, id, 1, 101).error().code, ErrorCode::out_of_range);
  EXPECT_EQ(run_derivations(*runs_, id, 2, 122).error().code, ErrorCode::out_of_range);
  EXPECT_EQ(run_derivations(*runs_, id, 3, 2).error().code, ErrorCode::out_of_range);
  EXPECT_EQ(number(run_derivations(*runs_, id, 0, 0)->find("steps")->as_list().at(0), "step"), 121);
  EXPECT_EQ(run_derivations(*runs_, 9, 0, 0).error().code, ErrorCode::not_found);
}

TEST_F(RunReplay, DerivesNothingOfARunThatHasNotBegun) {
  const RunId id = runs_->create(run_of(counting({})), 1)->id;
  EXPECT_TRUE(run_derivations(*runs_, id, 0, 0)->find("steps")->as_list().empty());
}

TEST_F(RunReplay, ComparesInPartsOfBoundedLength) {
  std::vector<int> ticks(10, 0);
  const RunId one = add(ticks);
  ticks.back() = 1;
  const RunId other = add(ticks);
  Value found = compare_runs(*runs_, one, other, 1, 4).value();
  EXPECT_TRUE(found.find("same")->as_bool());
  EXPECT_EQ(number(found, "next"), 5);
  found = compare_runs(*runs_, one, other, 5, 100).value();
  EXPECT_FALSE(found.find("same")->as_bool());
  EXPECT_EQ(number(found, "step"), 11);
  EXPECT_EQ(found.find("micro"), nullptr) << "derivations do not have the data of an event";
  EXPECT_EQ(found.find("next"), nullptr);
  found = compare_runs(*runs_, one, one, 1, 100).value();
  EXPECT_TRUE(found.find("same")->as_bool());
  EXPECT_EQ(number(found, "compared"), 11);
  EXPECT_EQ(found.find("next"), nullptr);
  EXPECT_EQ(compare_runs(*runs_, one, other, 13, 100).error().code, ErrorCode::out_of_range);
  EXPECT_EQ(compare_runs(*runs_, one, 7, 1, 100).error().code, ErrorCode::not_found);
}

}  // namespace
}  // namespace race::server
