// Work: evaluations are charged for what they do with data (core/SEMANTICS.md section 8, Budget).
#include <gtest/gtest.h>

#include "tests/unit/core/language/environment.h"
#include "tests/unit/core/language/work_cases.h"

namespace race::language::test {
namespace {

constexpr std::uint64_t kMuch = 1'000'000'000;

std::uint64_t work_of(Runner& r, const std::string& text) {
  EXPECT_EQ(r.function(text), "") << text << ": " << r.interpreter.fault().message;
  return r.interpreter.work();
}

std::string after(const WorkCase& each, const char* operation) {
  return (*each.before ? std::string(each.before) + "\n" : "") + "for once in range(1):\n    " + operation;
}

std::uint64_t work_of_operation(const WorkCase& each) {
  Runner r(Interpreter::Limits{.steps = kMuch});
  const std::uint64_t with = work_of(r, after(each, each.operation));
  return with - work_of(r, after(each, "pass"));
}

TEST(Work, IsChargedForMuchDataWhateverTheOperation) {
  for (const WorkCase& each : kWorkCases) {
    const std::uint64_t work = work_of_operation(each);
    EXPECT_TRUE(each.has_much_data ? work >= 1000 : work <= 300) << each.name << ": " << work;
  }
}

TEST(Work, IsTheSameEachTime) {
  for (const WorkCase& each : kWorkCases) EXPECT_EQ(work_of_operation(each), work_of_operation(each)) << each.name;
}

TEST(Work, OfOneOperationCannotExceedTheBudget) {
  for (const WorkCase& each : kWorkCases) {
    if (!each.has_much_data) continue;
    Runner r(Interpreter::Limits{.steps = kMuch});
    const std::uint64_t before = work_of(r, after(each, "pass"));
    const std::uint64_t budget = before + work_of_operation(each) / 2;
    Runner limited(Interpreter::Limits{.steps = budget});
    EXPECT_EQ(limited.function(after(each, each.operation)), "fault budget") << each.name;
    EXPECT_EQ(limited.interpreter.fault().message, "more than " + std::to_string(budget) + " steps");
    EXPECT_LE(limited.interpreter.work(), budget);
  }
}

TEST(Work, OfALoopThatRepeatsALongOperationIsBounded) {
  Runner r;
  // Each of these took seconds for a few units when nodes alone were counted.
  for (const char* text :
       {"a = 'ab' * 400000\nb = 'ab' * 200000 + 'c'\nwhile True: n = a.find(b)",
        "a = list(range(200000))\nwhile True: b = sorted(a)", "a = [0] * 200000\nwhile True: b = a + a",
        "a = 'a' * 500000\nwhile True: b = a.upper()", "a = [0] * 200000\nwhile True: n = 1 in a",
        "a = ['x'] * 200000\nwhile True: b = str(a)", "a = [0] * 100000\nwhile True: a.insert(0, 1)",
        "a = [0] * 200000\nb = a + [1]\nwhile True: c = a < b"}) {
    EXPECT_EQ(r.function(text), "fault budget") << text;
  }
}

TEST(Work, OfAChangeIsThatOfACopyWhereSomethingElseHoldsTheList) {
  Runner r(Interpreter::Limits{.steps = kMuch});
  const std::string list = "l = list(range(10000))\n";
  const std::uint64_t own = work_of(r, list + "x = 0\nl[0] = 1"), shared = work_of(r, list + "x = l\nl[0] = 1"),
                      twice = work_of(r, list + "x = l\nl[0] = 1\nl[1] = 1");
  EXPECT_GE(shared, own + 5000);
  EXPECT_LT(twice, shared + 10) << "it is copied once";
}

TEST(Work, OfALocalThatNothingElseHoldsIsThatOfWhatIsAdded) {
  Runner r;
  EXPECT_LT(work_of(r, "a = list(range(10000))\nfor i in range(1000): a += [i]"), 100'000U);
  EXPECT_GT(work_of(r, "a = list(range(10000))\nb = a\na += [1]"), 10'000U);
}

TEST(Work, OfConditionsIsChargedToo) {
  Runner r(Interpreter::Limits{.steps = 100});
  r.state.set(State::par_a, Value(List(10'000, Value(1))));
  EXPECT_EQ(r.condition("2 in par.a"), "fault budget");
  EXPECT_EQ(r.expression("par.a + par.a"), "fault budget");
}

TEST(Fault, QuotesTheBeginningOfALongValue) {
  Runner r;
  EXPECT_EQ(r.function("d = {'a': 1}\nx = d['b' * 5000]"), "fault missing");
  EXPECT_LE(r.interpreter.fault().message.size(), 510U);
  EXPECT_EQ(r.interpreter.fault().message.substr(0, 4), "'bbb");
}

}  // namespace
}  // namespace race::language::test
