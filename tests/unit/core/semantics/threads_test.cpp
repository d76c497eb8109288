// Any number of runs on any threads share one Program (program.h): runs of random models side by side are what each is
// alone. What the thread sanitizer sees of core. RACE_SEED and RACE_SHARED_MODELS choose another run; both are printed.
#include <gtest/gtest.h>

#include <array>
#include <future>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "core/value/json.h"
#include "tests/unit/core/semantics/driven_run.h"
#include "tests/unit/core/semantics/random_models.h"
#include "tests/unit/core/semantics/random_runs.h"
#include "tests/unit/setting.h"

namespace race::semantics {
namespace {

using ProgramPtr = std::shared_ptr<const Program>;

struct Done {
  RunState state;
  std::vector<OutgoingCall> calls;
  std::string json;
};

// Inputs of `seed`, recorded as trees in every second run: then all states are visited.
Done drive(const ProgramPtr& program, std::uint64_t seed) {
  RandomModels random(seed);
  Budgets budgets;
  budgets.micro_steps = 300;
  DrivenRun run(*Run::create(program, {}, budgets));
  std::vector<OutgoingCall> calls;
  for (int i = 0; i < 30 && run.status() == Status::running; ++i) {
    if (i > 0) random.post<DrivenRun>({&run}, run.state().call_count);
    if (!run.has_input()) continue;
    NoRecorder nothing;
    TreeRecorder tree;
    seed % 2 == 0 ? run.macro_step(nothing) : run.macro_step(tree);
    for (OutgoingCall& call : run.take_calls()) calls.push_back(std::move(call));
  }
  return {run.state(), std::move(calls), to_json(run.state_json())};
}

TEST(SharedProgram, GivesEachThreadTheRunThatItHasAlone) {
  constexpr std::uint64_t kThreads = 4;
  const std::uint64_t seed = setting("RACE_SEED", 20261123), models = setting("RACE_SHARED_MODELS", 60);
  std::cout << "RACE_SEED=" << seed << " RACE_SHARED_MODELS=" << models << std::endl;
  std::size_t calls = 0;
  for (std::uint64_t i = 0; i < models; ++i) {
    RandomModels random(seed + i);
    const ProgramPtr program = *Program::build(random.model(), RandomModels::services());
    std::array<std::future<Done>, kThreads> together;
    for (std::uint64_t k = 0; k < kThreads; ++k)
      together[k] = std::async(std::launch::async, drive, std::cref(program), seed + i + k);
    for (std::uint64_t k = 0; k < kThreads; ++k) {
      const Done beside = together[k].get(), alone = drive(program, seed + i + k);
      ASSERT_TRUE(same(beside.state, alone.state)) << "seed " << seed + i << ", run " << k;
      ASSERT_EQ(beside.calls, alone.calls) << "seed " << seed + i << ", run " << k;
      ASSERT_EQ(beside.json, alone.json) << "seed " << seed + i << ", run " << k;
      calls += alone.calls.size();
    }
  }
  EXPECT_GT(calls, models) << "the runs do something";
}

}  // namespace
}  // namespace race::semantics
