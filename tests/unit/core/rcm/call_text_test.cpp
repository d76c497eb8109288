// The call of an external oracle, split into its parts.
#include "core/rcm/call_text.h"

#include <gtest/gtest.h>

namespace race::rcm {
namespace {

std::vector<CallText::Argument> arguments(std::string_view text) { return parse_call(text).value().arguments; }

TEST(CallText, HasServiceOperationAndArguments) {
  const auto call = parse_call(" svc.Oracle.decide(par, res, var) ");
  ASSERT_TRUE(call);
  EXPECT_EQ(call->service, "Oracle");
  EXPECT_EQ(call->operation, "decide");
  EXPECT_EQ(call->arguments, (std::vector<CallText::Argument>{{"", "par"}, {"", "res"}, {"", "var"}}));
  EXPECT_EQ(arguments("svc.O.d()"), std::vector<CallText::Argument>{});
}

TEST(CallText, SplitsAtCommasOutsideOfBracketsAndStrings) {
  EXPECT_EQ(arguments("svc.O.d([1, 2], f(a, {'b': 1}), 'x, \\', y', \"\"\"p, \" q\"\"\")"),
            (std::vector<CallText::Argument>{
                {"", "[1, 2]"}, {"", "f(a, {'b': 1})"}, {"", "'x, \\', y'"}, {"", "\"\"\"p, \" q\"\"\""}}));
  EXPECT_EQ(arguments("svc.O.d('a)b')").size(), 1U);
  EXPECT_EQ(arguments("svc.O.d(1,\n 2,)").size(), 2U);
}

TEST(CallText, KnowsKeywords) {
  EXPECT_EQ(arguments("svc.O.d(1, where = par.x, b=a == c)"),
            (std::vector<CallText::Argument>{{"", "1"}, {"where", "par.x"}, {"b", "a == c"}}));
  EXPECT_EQ(arguments("svc.O.d(a == b, c <= d)"), (std::vector<CallText::Argument>{{"", "a == b"}, {"", "c <= d"}}));
}

TEST(CallText, IsNothingButOneCallOfAnOperation) {
  for (const auto* text :
       {"", "decide()", "svc.decide()", "svc.O.decide", "svc.O.decide(", "svc.O.decide(1", "svc.O.d(')",
        "svc.O.d(1)(2)", "svc.O.d(1).x", "svc.O.d(1) + 1", "svc.a.b.c()", "svc['O'].d()", "svc.O.1()", "svc.O.d(1,,2)",
        "svc.O.d(,)", "svc.O.d(a=1, 2)", "svc.O.d(a=1, a=2)", "svc.O.d(1) # x", "svc.O.d(1 # x\n)"})
    EXPECT_FALSE(parse_call(text)) << text;
}

}  // namespace
}  // namespace race::rcm
