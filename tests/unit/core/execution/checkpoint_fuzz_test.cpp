// Random mutations of checkpoints: reading never crashes, and what is read can go on.
#include <gtest/gtest.h>

#include <array>
#include <iostream>

#include "core/execution/checkpoint.h"
#include "tests/unit/core/execution/journals.h"
#include "tests/unit/core/execution/mutator.h"
#include "tests/unit/setting.h"

namespace race::execution {
namespace {

constexpr std::array<const char*, 20> kWords = {
    "t",    "e0",      "o0",      "running",     "ended", "faulted",  "aborted", "active", "arrived",      "p0",
    "Root", "Root/S0", "Root/b0", "activations", "error", "executed", "served",  "data",   "left_through", ""};

struct Stored {
  JournalHeader header;
  Value json;
};

// A run that is not over has inputs that wait.
Stored stored(std::uint64_t seed) {
  auto [journal, execution] = random_journal(seed, 1 + static_cast<int>(seed % 12));
  for (const char* event : {"e0", "s0", "e1"}) execution.post_event("t", event, Dict{{"x", 1}});
  return {journal.header, checkpoint_json(execution)};
}

// Half of the mutations are within a state: the rest is short, and refused at once.
Value mutated(const Value& json, Mutator& mutator) {
  Value out = json;
  const Value* states = json.find("run")->find("states");
  if (!states || mutator.below(2) == 0) {
    mutator.mutate(out);
    return out;
  }
  Value changed = *states, run = *json.find("run");
  mutator.mutate(changed);
  run.mutable_dict().set("states", std::move(changed));
  out.mutable_dict().set("run", std::move(run));
  return out;
}

void go_on(Execution& execution, std::uint64_t seed) {
  semantics::RandomModels random(seed);
  if (execution.run().position() == 0) execution.start({.derivation = random.chance(0.5)});
  for (int step = 0; step < 8 && !execution.is_over(); ++step) {
    random.post<Execution>({&execution}, execution.run().state().call_count);
    execution.step({.derivation = random.chance(0.5)});
  }
  if (!execution.is_over()) execution.abort();
}

TEST(CheckpointFuzz, AMutatedCheckpointIsRefusedOrOneThatCanGoOn) {
  const std::uint64_t seed = setting("RACE_SEED", 20261122);
  const std::uint64_t mutations = setting("RACE_MUTATIONS", 4'000);
  std::cout << "RACE_SEED=" << seed << " RACE_MUTATIONS=" << mutations << std::endl;
  std::vector<Stored> all;
  for (std::uint64_t i = 0; i < 40; ++i) all.push_back(stored(seed + i));
  std::size_t taken = 0;
  for (std::size_t i = 0; i < mutations && !HasFailure(); ++i) {
    SCOPED_TRACE("RACE_SEED=" + std::to_string(seed) + ", mutation " + std::to_string(i));
    Mutator mutator(seed + i, kWords);
    const Stored& which = all[mutator.below(all.size())];
    auto read = read_checkpoint(which.header, mutated(which.json, mutator));
    if (!read) {
      EXPECT_FALSE(read.error().message.empty());
      continue;
    }
    ++taken;
    const Value json = checkpoint_json(*read);
    EXPECT_TRUE(read_checkpoint(which.header, json)) << to_json(json);
    go_on(*read, seed + i);
  }
  std::cout << taken << " of " << mutations << " read" << std::endl;
  EXPECT_GT(taken, mutations / 20) << "too few mutations are harmless to say something about what is read";
  EXPECT_LT(taken, mutations / 2) << "too few mutations do harm";
}

}  // namespace
}  // namespace race::execution
