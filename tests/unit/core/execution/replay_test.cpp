// Replays of random runs: from any checkpoint, to any micro step.
#include "core/execution/replay.h"

#include <gtest/gtest.h>

#include <atomic>
#include <iostream>

#include "core/execution/past.h"
#include "core/execution/why.h"
#include "tests/unit/core/execution/journals.h"
#include "tests/unit/core/semantics/random_runs.h"
#include "tests/unit/setting.h"

namespace race::execution {
namespace {

// The execution within macro step `step`, from 1, after `micro` micro steps, done from the beginning.
Execution within(const Journal& journal, std::size_t step, int micro) {
  const JournalHeader& header = journal.header;
  Execution execution = Execution::create(header.program, header.arguments, header.budgets).value();
  for (std::size_t i = 0; i + 1 < step; ++i) execution.replay(journal.entries[i], {}).value();
  execution.replay(journal.entries[step - 1], {}, static_cast<std::uint32_t>(micro)).value();
  return execution;
}

struct RandomReplay {
  explicit RandomReplay(std::uint64_t seed) : random(seed), journal(random_journal(seed, 60).first) {}
  std::size_t step() { return 1 + random.pick(journal.entries.size()); }
  semantics::RandomModels random;
  Journal journal;
  // Few and close: most questions begin at one, and they are thinned out.
  Replay replay{journal.header, std::make_shared<MemoryJournal>(journal.entries), 4, 3};
};

/// Asks `question(at, step, micro)` about random moments of random runs, in any order.
template <typename Question>
void ask_about_moments(std::uint64_t default_seed, Question question) {
  const std::uint64_t seed = setting("RACE_SEED", default_seed), journals = setting("RACE_JOURNALS", 100);
  std::cout << "RACE_SEED=" << seed << " RACE_JOURNALS=" << journals << std::endl;
  for (std::uint64_t i = 0; i < journals; ++i) {
    RandomReplay at(seed + i);
    for (int questions = 0; questions < 6; ++questions) {
      const std::size_t step = at.step();
      const int micro = static_cast<int>(at.random.pick(4));
      SCOPED_TRACE("seed " + std::to_string(seed + i) + ", " + std::to_string(step) + "/" + std::to_string(micro));
      question(at, step, micro);
      if (testing::Test::HasFatalFailure()) return;
    }
  }
}

TEST(Replay, ComesToTheStateWithinAnyMicroStepInAnyOrderOfQuestions) {
  ask_about_moments(5, [](RandomReplay& at, std::size_t step, int micro) {
    auto past = at.replay.before(step, micro);
    ASSERT_TRUE(past) << past.error().message;
    Execution expected = within(at.journal, step, micro);
    ASSERT_TRUE(same(past->run().state(), expected.run().state()));
    ASSERT_EQ(past->micro(), expected.micro());
    const auto ports = static_cast<std::uint32_t>(at.journal.header.program->ports.size());
    for (std::uint32_t port = 0; port < ports; ++port)
      ASSERT_EQ(why_json(*past, semantics::PortId{port}), why_json(expected, semantics::PortId{port}));
  });
}

TEST(Replay, ShowsTheSameMomentHoweverItIsReached) {
  ask_about_moments(23, [](RandomReplay& at, std::size_t step, int micro) {
    const auto there = past(at.replay, step, micro);
    ASSERT_TRUE(there) << there.error().message;
    const Execution expected = within(at.journal, step, micro);
    ASSERT_EQ(there->text, moment_text(expected));
    ASSERT_EQ(*there->json.find("state"), expected.run().state_json());
    ASSERT_EQ(*there->json.find("micro"), Value(static_cast<std::int64_t>(expected.micro_steps())));
    const auto next = past(at.replay, step, micro + 1);
    ASSERT_TRUE(next) << next.error().message;
    ASSERT_EQ(there->text == next->text, there->json.find("complete")->as_bool()) << "forward leads on, or it is over";
  });
}

TEST(Replay, DerivesAnyStepsAndOfAnOpenOneTheFirstMicroSteps) {
  const std::uint64_t seed = setting("RACE_SEED", 11), journals = setting("RACE_JOURNALS", 100);
  std::cout << "RACE_SEED=" << seed << " RACE_JOURNALS=" << journals << std::endl;
  std::size_t partial = 0;
  for (std::uint64_t i = 0; i < journals; ++i) {
    RandomReplay at(seed + i);
    SCOPED_TRACE("seed " + std::to_string(seed + i));
    const List whole = derived_steps(at.journal).value();
    for (int questions = 0; questions < 4; ++questions) {
      const std::size_t from = at.step(), to = from + at.random.pick(at.journal.entries.size() - from + 1);
      const auto steps = at.replay.steps(from, to, at.journal.entries.size(), -1);
      ASSERT_TRUE(steps) << steps.error().message;
      ASSERT_EQ(steps->size(), to - from + 1);
      for (std::size_t k = 0; k < steps->size(); ++k) {
        ASSERT_EQ(*(*steps)[k].find("micro"), *whole[from - 1 + k].find("micro"));
        ASSERT_EQ(*(*steps)[k].find("state"), *whole[from - 1 + k].find("state"));
      }
    }
    const std::size_t last = at.journal.entries.size(), micro = whole.back().find("micro")->as_list().size();
    if (micro < 2) continue;
    ++partial;
    const Value open = at.replay.steps(last, last, last, 1).value()[0];
    EXPECT_EQ(open.find("micro")->as_list().size(), 1U);
    EXPECT_EQ(open.find("micro")->as_list()[0], whole.back().find("micro")->as_list()[0]);
    EXPECT_EQ(*open.find("complete"), Value(false));
  }
  EXPECT_GT(partial, journals / 20);
}

/// Says stop when its entries are read for the `reads`-th time.
struct StoppingJournal final : JournalSource {
  StoppingJournal(const Journal& journal, int reads) : memory(journal.entries), left(reads) {}
  Expected<std::vector<JournalEntry>> entries(std::uint64_t from, std::uint64_t to) override {
    if (--left == 0) stop = true;
    return memory.entries(from, to);
  }
  Expected<Value> checkpoint(std::uint64_t position) override { return memory.checkpoint(position); }
  MemoryJournal memory;
  int left;
  std::atomic<bool> stop{false};
};

TEST(Replay, ThatIsStoppedGivesNothingAndKeepsNothingHalfDone) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    RandomReplay at(seed);
    if (at.journal.entries.size() < 2) continue;
    const auto source = std::make_shared<StoppingJournal>(at.journal, 2);
    Replay replay(at.journal.header, source, 4, 3);
    const std::size_t last = at.journal.entries.size(), step = at.step();
    EXPECT_EQ(replay.steps(last, last, last, -1, &source->stop).error().code, ErrorCode::unavailable);
    EXPECT_EQ(replay.before(step, 1, &source->stop).error().code, ErrorCode::unavailable);
    EXPECT_EQ(replay.after(last, &source->stop).error().code, ErrorCode::unavailable);
    EXPECT_TRUE(same(replay.before(step, 1)->run().state(), within(at.journal, step, 1).run().state()));
    EXPECT_TRUE(same(replay.after(last)->run().state(), within(at.journal, last, 1 << 20).run().state()));
  }
}

TEST(Replay, IsStoppedBetweenTheMicroStepsOfAMacroStep) {
  const auto document =
      rcm::read_document_text(R"({"rcm": 1, "root": {"state": "R", "first": "A", "children": [)"
                              R"({"state": "A", "ports": [{"name": "next", "when": "True", "to": "B"}]},)"
                              R"({"state": "B", "ports": [{"name": "next", "when": "True", "to": "A"}]}]}})");
  const Journal journal = journal_of(document.value(), {});
  Execution execution = Execution::create(journal.header).value();
  const std::atomic<bool> stop{true};
  execution.stop_with(&stop);
  EXPECT_EQ(execution.replay(StartEntry{}, {}).error().code, ErrorCode::unavailable);
  EXPECT_LE(execution.micro(), 1U);
}

TEST(Replay, RefusesAJournalOfAnotherRun) {
  const auto replay_of = [](std::vector<JournalEntry> entries) {
    return Replay(small_journal().header, std::make_shared<MemoryJournal>(std::move(entries)));
  };
  EXPECT_EQ(replay_of({StartEntry{}, StartEntry{}}).steps(1, 2, 2, -1).error().code, ErrorCode::conflict);
  EXPECT_EQ(replay_of({EventEntry{"t", "tick", Value()}}).before(1, 0).error().code, ErrorCode::conflict)
      << "a run begins with `start`";
  EXPECT_EQ(replay_of({AbortEntry{}, StartEntry{}}).steps(1, 2, 2, -1).error().code, ErrorCode::conflict);
}

}  // namespace
}  // namespace race::execution
