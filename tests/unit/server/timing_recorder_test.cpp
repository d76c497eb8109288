// What a core notes of times, and what is known by it of what waited at an earlier moment.
#include "server/execution/timing_recorder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "server/execution/waiting_then.h"
#include "tests/unit/core/execution/journals.h"

namespace race::server {
namespace {

using execution::Execution;

// Three micro steps in each macro step that a `go` begins; `seen` is sampled.
execution::JournalHeader header() {
  static constexpr const char* kDocument = R"json({"rcm": 1, "services": {"t": "timer"}, "root": {
    "state": "Root", "first": "A", "entry": "svc.t.wait(1)",
    "actions": [{"when": "svc.t.seen", "do": "var.seen = svc.t.seen"}],
    "children": [{"state": "A", "ports": [{"name": "next", "when": "svc.t.go", "to": "B"}]},
                 {"state": "B", "entry": "var.b = 1", "ports": [{"name": "next", "when": "True", "to": "A"}]}],
    "ports": [{"name": "done", "when": "svc.t.wait.result"}]}})json";
  const rsm::Service timer =
      rsm::read_service_text(
          R"({"operations": [{"name": "wait"}], "events": [{"name": "go"}, {"name": "seen", "sampled": true}]})",
          "timer")
          .value();
  return execution::journal_of(rcm::read_document_text(kDocument).value(), {{"t", timer}}).header;
}

struct TimingRecorderTest : testing::Test {
  void post(const char* event, int data) {
    ASSERT_TRUE(run.post_event("t", event, Value(data)));
    recorder.arrived(run, TimingRecorder::Clock::now());
  }
  /// A macro step, at most `limit` micro steps of it.
  void step(std::uint32_t limit = Execution::kNoLimit) {
    const auto begin = TimingRecorder::Clock::now();
    const execution::Progress& progress = run.run().position() == 0 ? run.start({}, limit) : run.step({}, limit);
    recorder.began(run, progress.entry, begin);
    if (run.is_over()) recorder.ended(run);
  }
  void write() {
    stored.push_back(recorder.take_block(run, ++ticket));
    recorder.durable(ticket);
  }
  /// The data of what waited, with the macro step that delivered it; nothing: it is not known.
  std::optional<std::vector<std::pair<int, std::uint64_t>>> waited(Moment moment, bool only_stored = false) const {
    WaitingThen waiting(moment);
    std::vector<TimingBlock> blocks = stored;
    if (!only_stored)
      for (const TimingBlock& block : recorder.blocks()) blocks.push_back(block);
    for (const TimingBlock& block : blocks)
      if (block.last() >= moment.step && !waiting.take(block)) break;
    const auto inputs = waiting.inputs();
    if (!inputs) return std::nullopt;
    std::vector<std::pair<int, std::uint64_t>> found;
    for (const WaitedInput& each : *inputs) {
      const auto* event = each.undelivered ? std::get_if<execution::EventEntry>(&*each.undelivered) : nullptr;
      found.emplace_back(event ? static_cast<int>(event->data.as_integer()) : 0, each.step);
    }
    return found;
  }
  using Found = std::vector<std::pair<int, std::uint64_t>>;
  static Moment end(std::uint64_t step) { return {step, Moment::kEnd}; }

  Execution run = Execution::create(header()).value();
  TimingRecorder recorder{0};
  std::vector<TimingBlock> stored;
  std::uint64_t ticket = 0;
};

TEST_F(TimingRecorderTest, KnowsWhatWaitedWhereverTheRunWas) {
  step();
  post("go", 1);
  post("go", 2);
  step(1);  // in the middle of step 2
  post("go", 3);
  EXPECT_EQ(waited({1, Moment::kEnd}), (Found{{0, 2}, {2, 0}}));
  EXPECT_EQ(waited({2, 0}), (Found{{2, 0}}));
  EXPECT_EQ(waited({2, 1}), (Found{{2, 0}, {3, 0}}));
  run.continue_step();
  step();
  step();
  write();
  for (const bool only_stored : {false, true}) {
    EXPECT_EQ(waited(end(1), only_stored), (Found{{0, 2}, {0, 3}}));
    EXPECT_EQ(waited({2, 0}, only_stored), (Found{{0, 3}}));
    EXPECT_EQ(waited({2, 1}, only_stored), (Found{{0, 3}, {0, 4}}));
    EXPECT_EQ(waited({3, 0}, only_stored), (Found{{0, 4}}));
    EXPECT_EQ(waited({4, 0}, only_stored), Found{});
  }
  EXPECT_EQ(waited(end(4)), Found{});
  EXPECT_EQ(waited(end(4), true), std::nullopt) << "the run has not gone on yet";
}

TEST_F(TimingRecorderTest, KnowsSamplesThatWereOverwritten) {
  step();
  post("go", 1);
  step(1);
  post("seen", 10);
  run.continue_step(1);
  post("seen", 11);
  post("seen", 12);
  run.continue_step();
  step();
  write();
  EXPECT_EQ(waited({2, 1}), (Found{{10, 0}}));
  EXPECT_EQ(waited({2, 2}), (Found{{0, 3}}));
}

TEST_F(TimingRecorderTest, KnowsWhatTheEndOfARunHasDropped) {
  step();
  ASSERT_TRUE(run.post_response(1, false, Value(0)));
  recorder.arrived(run, TimingRecorder::Clock::now());
  post("go", 7);
  step();
  ASSERT_TRUE(run.is_over());
  write();
  EXPECT_EQ(waited(end(1), true), (Found{{0, 2}, {7, 0}}));
  EXPECT_EQ(waited(end(2), true), Found{});
}

TEST_F(TimingRecorderTest, DoesNotKnowWhatALostBlockHad) {
  step();
  post("go", 1);
  step();
  write();
  step();
  stored.clear();
  post("go", 2);
  step();
  write();
  EXPECT_EQ(waited(end(1)), std::nullopt);
}

TEST_F(TimingRecorderTest, ForgetsWhatARebuiltRunHasNotDone) {
  step();
  Execution before = run;
  post("go", 1);
  step();
  post("go", 2);
  run = before;
  recorder.rebuilt(run);
  EXPECT_FALSE(recorder.has_begun(2));
  EXPECT_EQ(waited(end(1)), Found{});
  post("go", 3);
  step();
  write();
  ASSERT_EQ(stored.back().steps.size(), 1U);
  EXPECT_EQ(stored.back().first, 2U);
  EXPECT_EQ(waited(end(1)), (Found{{0, 2}}));
  EXPECT_EQ(waited({1, 0}), std::nullopt);
}

TEST_F(TimingRecorderTest, KeepsABoundedNumberOfWhatIsNotDelivered) {
  step();
  for (int i = 0; i < 300; ++i) post("go", i);
  run.drop_waiting();
  recorder.ended(run);
  EXPECT_EQ(waited({1, 0}), Found{}) << "they came at its end";
  EXPECT_EQ(recorder.take_block(run, 1).undelivered.size(), 0U);
  step(0);
  for (int i = 0; i < 300; ++i) post("go", i);
  run.continue_step();
  run.drop_waiting();
  recorder.ended(run);
  EXPECT_EQ(waited({2, 0}), std::nullopt);
  EXPECT_EQ(recorder.take_block(run, 2).undelivered.size(), TimingBlock::kMostUndelivered);
}

TEST_F(TimingRecorderTest, NotesHowTheStatesOfItsServicesChange) {
  recorder.use({{0, "t", "Idle"}});
  EXPECT_FALSE(recorder.service_changed("t", "Idle"));
  EXPECT_FALSE(recorder.service_changed("other", "Busy"));
  EXPECT_TRUE(recorder.service_changed("t", "Busy"));
  EXPECT_TRUE(recorder.service_changed("t", std::nullopt));
  step();
  const auto states = [](const TimingBlock& block) {
    std::vector<std::optional<std::string>> found;
    for (const ServiceChange& change : block.services) found.push_back(change.state);
    return found;
  };
  using States = std::vector<std::optional<std::string>>;
  EXPECT_EQ(states(recorder.take_block(run, 1)), (States{"Idle", "Busy", std::nullopt}));
  EXPECT_FALSE(recorder.has_news());
  EXPECT_EQ(states(recorder.take_block(run, 2)), States{std::nullopt}) << "a block says what was";
  for (std::size_t i = 0; i < 2 * TimingBlock::kMostChanges; ++i)
    recorder.service_changed("t", i % 2 == 0 ? "Busy" : "Idle");
  const TimingBlock full = recorder.take_block(run, 3);
  EXPECT_EQ(full.services.size(), TimingBlock::kMostChanges);
  EXPECT_EQ(full.services.back().state, "Idle");
}

TEST_F(TimingRecorderTest, FollowsAnExecutionThatHasDroppedWhatWaited) {
  step();
  post("go", 1);
  run.drop_waiting();
  post("seen", 2);
  step();
  write();
  EXPECT_EQ(waited(end(1)), (Found{{0, 2}}));
}

}  // namespace
}  // namespace race::server
