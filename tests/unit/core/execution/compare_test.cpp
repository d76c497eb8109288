// Comparison of runs: random ones with themselves, and with what was changed in them.
#include "core/execution/compare.h"

#include <gtest/gtest.h>

#include <iostream>

#include "core/execution/replay.h"
#include "tests/unit/core/execution/journals.h"
#include "tests/unit/setting.h"

namespace race::execution {
namespace {

JournalWalk walk_of(const Journal& journal, std::uint64_t from = 1) {
  auto source = std::make_shared<MemoryJournal>(journal.entries);
  Replay replay(journal.header, source);
  return JournalWalk(replay.after(from - 1).value(), source, journal.entries.size());
}

Comparison compared(const Journal& first, const Journal& second, std::uint64_t most = 1000, std::uint64_t from = 1) {
  JournalWalk a = walk_of(first, from), b = walk_of(second, from);
  return compare(a, b, most).value();
}

// A run of a task that counts what `t.tick` brings.
Journal counting(const std::vector<int>& ticks, int first = 0) {
  static const rcm::Document document = rcm::read_document_text(R"({"rcm": 1, "services": {"t": "timer"},
    "root": {"state": "Root", "parameters": [{"name": "first", "value": 0}], "results": [{"name": "n", "initial": 0}],
             "actions": [{"when": "svc.t.tick", "do": "res.n = res.n + svc.t.tick"}]}})")
                                            .value();
  static const rsm::Service timer = rsm::read_service_text(R"({"events": [{"name": "tick"}]})", "timer").value();
  Journal journal = journal_of(document, {{"t", timer}}, Dict{{"first", first}});
  journal.entries.emplace_back(StartEntry{});
  for (const int tick : ticks) journal.entries.emplace_back(EventEntry{"t", "tick", tick});
  return journal;
}

TEST(Compare, FindsNoDifferenceBetweenARunAndItself) {
  const std::uint64_t seed = setting("RACE_SEED", 5), journals = setting("RACE_JOURNALS", 50);
  std::cout << "RACE_SEED=" << seed << " RACE_JOURNALS=" << journals << std::endl;
  for (std::uint64_t i = 0; i < journals; ++i) {
    SCOPED_TRACE("seed " + std::to_string(seed + i));
    const Journal journal = random_journal(seed + i, 40).first;
    const Comparison whole = compared(journal, journal);
    EXPECT_FALSE(whole.difference);
    EXPECT_EQ(whole.compared, journal.entries.size());
  }
}

TEST(Compare, FindsTheFirstStepThatDiffers) {
  const Comparison found = compared(counting({1, 2, 3, 4}), counting({1, 2, 5, 4}));
  EXPECT_EQ(found.compared, 3u);
  ASSERT_TRUE(found.difference);
  EXPECT_EQ(found.difference->step, 4u);
  EXPECT_EQ(*found.difference->first.find("input")->find("data"), Value(3));
  EXPECT_EQ(*found.difference->second.find("input")->find("data"), Value(5));
}

// A run whose first macro step goes from A to B, and on to C if `condition` is fulfilled; B's entry is `entry`.
Journal passing(const std::string& condition, const std::string& entry = "pass") {
  const std::string b = R"({"state": "B", "results": [{"name": "r"}], "entry": ")" + entry +
                        R"(", "ports": [{"name": "next", "when": ")" + condition + R"(", "to": "C"}]})";
  const std::string document = R"({"rcm": 1, "root": {"state": "Root", "first": "A", "children": [
    {"state": "A", "ports": [{"name": "next", "when": "True", "to": "B"}]}, )" +
                               b + R"(, {"state": "C"}]}})";
  Journal journal = journal_of(rcm::read_document_text(document).value(), {});
  journal.entries.emplace_back(StartEntry{});
  return journal;
}

std::size_t micro_steps(const Value& step) { return step.find("micro")->as_list().size(); }

TEST(Compare, FindsTheFirstDerivationThatDiffers) {
  const auto found = compared(passing("1 < 2"), passing("not 2 < 1")).difference;
  ASSERT_TRUE(found);
  EXPECT_EQ(found->step, 1u);
  EXPECT_EQ(found->micro, 3u) << "the one that begins to leave B";
  EXPECT_EQ(micro_steps(found->first), micro_steps(found->second));
}

TEST(Compare, FindsTheDerivationThatOneStepDoesNotHave) {
  const Journal longer = passing("True"), shorter = passing("False");
  const auto found = compared(longer, shorter).difference, turned = compared(shorter, longer).difference;
  ASSERT_TRUE(found && turned);
  EXPECT_LT(micro_steps(found->second), micro_steps(found->first));
  EXPECT_EQ(found->micro, micro_steps(found->second));
  EXPECT_EQ(turned->micro, found->micro);
}

TEST(Compare, FindsNoDerivationIfOnlyTheStateDiffers) {
  const auto found = compared(passing("True", "res.r = 1"), passing("True", "res.r = 2")).difference;
  ASSERT_TRUE(found);
  EXPECT_EQ(found->micro, std::nullopt);
  EXPECT_NE(*found->first.find("state"), *found->second.find("state"));
}

TEST(Compare, FindsTheStepThatOneRunDoesNotHave) {
  const Comparison found = compared(counting({1, 2}), counting({1}));
  ASSERT_TRUE(found.difference);
  EXPECT_EQ(found.difference->step, 3u);
  EXPECT_EQ(found.difference->micro, std::nullopt);
  EXPECT_TRUE(found.difference->first.is_dict());
  EXPECT_TRUE(found.difference->second.is_null());
}

TEST(Compare, FindsArgumentsThatMakeADifference) {
  const Comparison found = compared(counting({1}, 0), counting({1}, 1));
  ASSERT_TRUE(found.difference);
  EXPECT_EQ(found.difference->step, 1u);
}

TEST(Compare, StopsAtItsBoundAndGoesOnFromThere) {
  const Journal one = counting({1, 2, 3, 4, 5}), other = counting({1, 2, 3, 4, 6});
  const Comparison part = compared(one, other, 3);
  EXPECT_FALSE(part.difference);
  EXPECT_EQ(part.compared, 3u);
  const Comparison rest = compared(one, other, 3, part.compared + 1);
  ASSERT_TRUE(rest.difference);
  EXPECT_EQ(rest.difference->step, 6u);
}

TEST(Compare, ReportsAnEntryThatTheRunDoesNotTake) {
  Journal wrong = counting({1, 2});
  wrong.entries[2] = ResponseEntry{7, "t", "go", false, Value()};
  JournalWalk a = walk_of(counting({1, 2})), b = walk_of(wrong);
  const auto found = compare(a, b, 10);
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().code, ErrorCode::conflict);
  EXPECT_EQ(found.error().path, "entries/2");
}

}  // namespace
}  // namespace race::execution
