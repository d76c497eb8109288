// Properties of every run, held on random models of random_models.h. RACE_SEED and RACE_STEPS (of all parts together)
// choose another run; both are printed.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/value/json.h"
#include "tests/unit/core/semantics/driven_run.h"
#include "tests/unit/core/semantics/random_models.h"
#include "tests/unit/core/semantics/random_runs.h"
#include "tests/unit/setting.h"

namespace race::semantics {
namespace {

// The invariant of core/SEMANTICS.md section 9; the first violation, or nothing.
std::string violation(const semantics::Run& run) {
  const Program& p = run.program();
  const RunState& r = run.state();
  for (std::uint32_t i = 0; i < p.states.size(); ++i) {
    const StateInfo& s = p.states[i];
    const bool active = r.flags[i] != 0;
    const bool parent_active = s.parent == kNoState || r.flags[index(s.parent)] != 0;
    if (active && !parent_active) return s.path + " is active, its parent is not";
    for (std::size_t k = 0; active && k < s.parameters.size(); ++k)
      if (r.values[s.first_parameter + k].is_unknown()) return s.path + " is active without " + s.parameters[k].name;
    for (const PortId port : s.ports)
      if (r.flags[p.flag(port)] && (active || !parent_active)) return p.address(port) + " is active at the wrong time";
  }
  for (std::size_t i = 0; i < p.barriers.size(); ++i) {
    const BarrierInfo& b = p.barriers[i];
    const bool parent_active = r.flags[index(b.parent)] != 0;
    const auto arrived = std::ranges::count_if(b.in, [&](PortId port) { return r.arrived[index(port)] != 0; });
    if (run.status() == Status::running && r.arrivals[i] != static_cast<std::size_t>(arrived))
      return b.path + " counts its arrivals wrongly";
    for (const PortId port : b.in)
      if (r.arrived[index(port)] && !parent_active) return b.path + " keeps arrivals in an inactive parent";
  }
  if (r.started && run.status() == Status::running && !r.flags[0]) return "the root is not active";
  return "";
}

template <Recorder R>
std::vector<OutgoingCall> step(DrivenRun& run, R& recorder) {
  run.macro_step(recorder);
  return run.take_calls();
}

// The rules of a macro step by name, sorted (REFINEMENT R23 shows a Resolve later than it was evaluated).
std::vector<Rule> sorted_rules(const Derivation& derivation) {
  std::vector<Rule> rules;
  for (const DerivationNode& node : derivation.nodes)
    if (node.rule != Rule::CondBE && node.rule != Rule::CondBD && node.rule != Rule::FuncST &&
        node.rule != Rule::FuncSD && node.rule != Rule::FuncSC)
      rules.push_back(node.rule);
  std::ranges::sort(rules);
  return rules;
}

struct Outcomes {
  std::uint64_t steps = 0, ended = 0, faulted = 0, models = 0, micro = 0;
};

// One model, driven for at most `limit` macro steps by three runs: one that skips what cannot matter (and, in every
// third model, records names now and then), one that records trees, and one that records names and skips nothing.
void drive(std::uint64_t seed, std::uint64_t limit, Outcomes& outcomes) {
  RandomModels random(seed);
  auto program = Program::build(random.model(), RandomModels::services());
  ASSERT_TRUE(program) << "seed " << seed << ": " << to_string(program.error()[0]);
  const Budgets budgets = RandomModels::budgets(seed);
  DrivenRun fast(*semantics::Run::create(*program, {}, budgets));
  DrivenRun recorded = fast;
  DrivenRun thorough = fast;
  DrivenRun checkpoint = fast;
  struct Done {
    std::optional<Input> input;
    Derivation derivation;
    std::vector<OutgoingCall> calls;
  };
  std::vector<Done> since;  // the checkpoint
  const bool mixes = random.chance(0.33);
  ++outcomes.models;
  for (std::uint64_t i = 0; i < limit && fast.status() == Status::running; ++i) {
    if (i > 0)
      for (std::size_t inputs = 1 + random.pick(2); inputs-- > 0;)
        random.post<DrivenRun>({&fast, &recorded, &thorough}, fast.state().call_count);
    if (!recorded.has_input()) continue;
    const bool traced = random.chance(0.02);  // replay compares whole derivations, now and then
    const std::optional<Input> input = DrivenRun(recorded).take_input();
    TreeRecorder tree;
    const std::vector<OutgoingCall> calls = step(recorded, tree);
    Derivation& derivation = tree.derivation;
    NameRecorder names;
    NoRecorder nothing;
    const bool named = mixes && random.chance(0.3);
    ASSERT_EQ(named ? step(fast, names) : step(fast, nothing), calls) << "seed " << seed << ", step " << i;
    NameRecorder all;
    ASSERT_EQ(step(thorough, all), calls) << "seed " << seed << ", step " << i;
    std::ranges::sort(all.names);
    ASSERT_EQ(all.names, sorted_rules(derivation)) << "seed " << seed << ", step " << i;
    std::ranges::sort(names.names);
    if (named) {
      ASSERT_EQ(names.names, all.names) << "seed " << seed << ", step " << i;
    }
    ASSERT_TRUE(same(thorough.state(), recorded.state())) << "seed " << seed << ", step " << i;
    ASSERT_TRUE(same(fast.state(), recorded.state()))
        << "seed " << seed << ", step " << i << "\nfast     " << to_json(fast.state_json()) << "\nrecorded "
        << to_json(recorded.state_json());
    ASSERT_EQ(fast.status(), recorded.status()) << "seed " << seed << ", step " << i;
    ASSERT_EQ(violation(fast), "") << "seed " << seed << ", step " << i;
    ++outcomes.steps;
    outcomes.micro += derivation.micro.size();
    since.push_back({input, std::move(derivation), calls});
    if (traced || since.size() > 50 || recorded.status() != Status::running) {
      DrivenRun replayed = checkpoint;
      for (const Done& done : since) {
        TreeRecorder recorder;
        replayed.begin(std::optional(done.input));
        while (replayed.micro(recorder)) {
        }
        ASSERT_EQ(recorder.derivation, done.derivation) << "seed " << seed << ", step " << i;
        ASSERT_EQ(replayed.take_calls(), done.calls) << "seed " << seed << ", step " << i;
      }
      ASSERT_TRUE(same(replayed.state(), recorded.state())) << "seed " << seed << ", step " << i;
      checkpoint = recorded;
      since.clear();
    }
  }
  outcomes.ended += fast.status() == Status::ended ? 1 : 0;
  outcomes.faulted += fast.status() == Status::faulted ? 1 : 0;
}

// Every second model each, in processes side by side (CMakeLists.txt): this is the longest test under a sanitizer.
constexpr std::uint64_t kParts = 2;

struct RandomRuns : testing::TestWithParam<std::uint64_t> {};

TEST_P(RandomRuns, KeepTheirInvariantsAndAgreeWithEveryWayOfRunningThem) {
  const std::uint64_t seed = setting("RACE_SEED", 20140901), steps = setting("RACE_STEPS", 1'000'000);
  std::cout << "RACE_SEED=" << seed << " RACE_STEPS=" << steps << ", part " << GetParam() << " of " << kParts
            << std::endl;
  Outcomes outcomes;
  for (std::uint64_t i = GetParam(); outcomes.steps * kParts < steps; i += kParts) {
    drive(seed + i, 300, outcomes);
    if (HasFatalFailure()) return;
  }
  std::cout << outcomes.models << " models, " << outcomes.steps << " macro steps, " << outcomes.micro
            << " micro steps, " << outcomes.ended << " ended, " << outcomes.faulted << " faulted" << std::endl;
  EXPECT_GT(outcomes.faulted, outcomes.models / 100);
  EXPECT_GT(outcomes.ended, outcomes.models / 100);
}

INSTANTIATE_TEST_SUITE_P(Part, RandomRuns, testing::Range<std::uint64_t>(0, kParts));

// R4: a discarded micro step leaves no trace in Δ.
TEST(RandomModels, AFaultLeavesDeltaAsAfterTheLastCompleteMicroStep) {
  const std::uint64_t seed = setting("RACE_SEED", 7), models = sample(3000);
  std::cout << "RACE_SEED=" << seed << ", " << models << " models" << std::endl;
  std::uint64_t faults = 0;
  for (std::uint64_t i = 0; i < models; ++i) {
    RandomModels random(seed + i);
    auto program = Program::build(random.model(), RandomModels::services());
    ASSERT_TRUE(program);
    const Budgets budgets = RandomModels::budgets(seed + i);
    DrivenRun run(*semantics::Run::create(*program, {}, budgets));
    for (int k = 0; k < 50 && run.status() == Status::running; ++k) {
      if (k > 0) random.post<DrivenRun>({&run}, run.state().call_count);
      run.begin(run.take_input());
      TreeRecorder recorder;
      RunState before = run.state();
      while (run.micro(recorder)) before = run.state();
      if (run.status() != Status::faulted) continue;
      ++faults;
      EXPECT_EQ(before.values, run.state().values) << "seed " << seed + i;
      EXPECT_EQ(before.flags, run.state().flags) << "seed " << seed + i;
      EXPECT_EQ(before.arrived, run.state().arrived) << "seed " << seed + i;
      EXPECT_EQ(before.triggered, run.state().triggered) << "seed " << seed + i;
      EXPECT_EQ(before.calls, run.state().calls) << "seed " << seed + i;
    }
  }
  EXPECT_GT(faults, models / 30);
}

}  // namespace
}  // namespace race::semantics
