// Texts that are not code of the function language, by the code of their violation.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "tests/unit/core/language/environment.h"

namespace race::language::test {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

std::set<std::string> codes(std::string_view text, CodeKind kind) {
  const State state;
  std::set<std::string> found;
  for (const Error& error : check(text, kind, state.symbols)) found.insert(std::string(name(error.code)));
  return found;
}
auto in_condition(std::string_view text) { return codes(text, CodeKind::condition); }
auto in_expression(std::string_view text) { return codes(text, CodeKind::expression); }
auto in_function(std::string_view text) { return codes(text, CodeKind::function); }

TEST(Check, AcceptsWhatTheScopesHave) {
  EXPECT_THAT(in_condition("par.a and res.x and var.anything and port.p and chi.C and chi.C.active and chi.C.res.x"),
              IsEmpty());
  EXPECT_THAT(in_condition("chi.C.port.q or chi.b or chi.b.active or chi.C.name == 'C'"), IsEmpty());
  EXPECT_THAT(in_condition("svc.any.op.result and svc.any.ev.x > svc['t'].ev.latest or available(svc.t.op.error)"),
              IsEmpty());
  EXPECT_THAT(in_expression("[x * par.a for x in range(3)] + [len(res), len(par), var.get('k')]"), IsEmpty());
  EXPECT_THAT(in_function("svc.t.op(1, speed=2)\nsvc['t'].op()\nif chi.C:\n    svc.t.stop()"), IsEmpty());
  EXPECT_THAT(in_function("res.x = 1; var.new = 2\nvar.l[0] = res.x\nvar.l.append(3)\na, (b, [c]) = 1, [2, [3]]"),
              IsEmpty());
  EXPECT_THAT(in_function(""), IsEmpty());
  EXPECT_THAT(in_function("# nothing but a comment\n\n"), IsEmpty());
  EXPECT_THAT(in_function("if par.a:\n\tres.x = (1 +\n2) # why\n\telse_ = 2\r\nelif 1: pass\nelse:\n        pass\n"),
              IsEmpty());
  EXPECT_THAT(in_condition("  par.a == 1 "), IsEmpty());
}

TEST(Check, SyntaxIsWhatIsNotPython) {
  for (const char* text : {"",
                           "while",
                           "a = 1",
                           "(1",
                           "1)",
                           "[1, 2",
                           "1 +",
                           "'open",
                           "x y",
                           "f(a=1, 2)",
                           "f(a=1, a=2)",
                           "1 if 2",
                           "not",
                           "a..b",
                           "012",
                           "1__0",
                           "0x",
                           "1e",
                           "$",
                           "f'{'",
                           "f'}'",
                           "f'{}'",
                           "f'{1!x}'",
                           "'\\x1'",
                           "par.a\nres.x",
                           "a if b else",
                           "print 1",
                           "{1: 2",
                           "{'a': }",
                           "1 2",
                           "'a' 1",
                           "f'{1:{2:{3}}}'"})
    EXPECT_THAT(in_condition(text), ElementsAre("syntax")) << text;
  for (const char* text : {"break",
                           "continue",
                           "if 1:\npass",
                           "if 1:",
                           "  x = 1",
                           "if 1:\n  x = 1\n y = 2",
                           "1 = 2",
                           "f() = 1",
                           "x + 1 = 2",
                           "None = 1",
                           "else: pass",
                           "for x in: pass",
                           "a, b += 1",
                           "x = ",
                           "if 1: if 2: pass",
                           "if 1:\n\tx = 1\n        y = 2",
                           "if 1:\n \tif 2:\n  \tpass",
                           "pass pass",
                           "if x = 1: pass",
                           "\\"})
    EXPECT_THAT(in_function(text), ElementsAre("syntax")) << text;
}

TEST(Check, ForbiddenIsPythonOutsideOfTheLanguage) {
  for (const char* text : {"{1, 2}",
                           "{x: 1 for x in []}",
                           "{x for x in []}",
                           "(x for x in [])",
                           "sum(x for x in [])",
                           "lambda: 1",
                           "1 & 2",
                           "1 | 2",
                           "1 ^ 2",
                           "1 << 2",
                           "~1",
                           "1 @ 2",
                           "1 is 2",
                           "(1, 2)",
                           "()",
                           "1, 2",
                           "[*par.a]",
                           "{**par.a}",
                           "max(*par.a)",
                           "dict(**par.a)",
                           "b'x'",
                           "1j",
                           "...",
                           "(x := 1)",
                           "res.x.__class__",
                           "'%d' % 1",
                           "'a'.format(1)",
                           "sorted([], key=len)",
                           "res.x.encode()",
                           "[1][0, 1]",
                           "res.x()",
                           "[1]()",
                           "9223372036854775808",
                           "'\\ud800'",
                           "'\\N{DASH}'",
                           "await par.a",
                           "é"})
    EXPECT_THAT(in_condition(text), ::testing::Contains("forbidden")) << text;
  for (const char* text : {"import os",
                           "from os import path",
                           "def f():\n    pass",
                           "class C:\n    pass",
                           "try:\n    pass\nfinally:\n    pass",
                           "try:\n    pass\nexcept:\n    pass\nelse:\n    pass",
                           "with x:\n    pass",
                           "return",
                           "raise x",
                           "assert 1",
                           "del x",
                           "global x",
                           "for i in [1]:\n    pass\nelse:\n    pass",
                           "while 0:\n    pass\nelse:\n    pass",
                           "x = 1, 2",
                           "x: int = 1",
                           "x = []\nx[0:1] = []",
                           "x = {}\nx.y = 1",
                           "var.x.y = 1",
                           "*a, b = [1]",
                           "@f\ndef g():\n    pass",
                           "yield 1",
                           "x = 1\nx &= 1",
                           "__x = 1",
                           "svc.t.__op()",
                           "svc.t.op(__a=1)",
                           "for x in 1, 2: pass",
                           "x = 1\nx()",
                           "[var.x for var.x in []]"})
    EXPECT_THAT(in_function(text), ::testing::Contains("forbidden")) << text;
  EXPECT_THAT(in_function("import os\nx = 1\nclass C:\n    def f(self):\n        pass\nres.x = y"),
              ElementsAre("forbidden", "unknown_name"))
      << "all violations are listed";
}

TEST(Check, ScopeIsAPlaceThatCannotBeUsedLikeThis) {
  for (const char* text : {"print", "len", "math", "geo", "math.sin", "chi", "port", "svc", "svc.t", "svc['t']",
                           "chi.C.res", "chi.C.port"})
    EXPECT_THAT(in_condition(text), ElementsAre("scope")) << text;
  for (const char* text : {"par.a = 1", "par.a += 1", "par.a[0] = 1", "chi.C.res.x = 1", "port.p = True",
                           "svc.t.ev = 1", "max = 3", "svc = 1", "math = 1", "for len in []: pass", "par = {}",
                           "res = {}", "res['x'] = 1", "par.a.append(1)", "chi.C.res.x.append(1)", "svc.t.ev.x.clear()",
                           "res.update({})", "x = [print for print in []]", "a, min = 1, 2"})
    EXPECT_THAT(in_function(text), ::testing::Contains("scope")) << text;
  EXPECT_THAT(in_expression("svc.t.data"), ElementsAre("scope"));
  EXPECT_THAT(in_expression("port.p"), ElementsAre("scope"));
  EXPECT_THAT(in_expression("svc.t.op()"), ElementsAre("scope"));
}

TEST(Check, EffectIsAChangeOutsideOfAFunction) {
  EXPECT_THAT(in_condition("res.x.append(1)"), ElementsAre("effect"));
  EXPECT_THAT(in_condition("[1, 2].pop() == 2"), ElementsAre("effect"));
  EXPECT_THAT(in_expression("var.d.setdefault('a', 1)"), ElementsAre("effect"));
}

TEST(Check, AServiceCallIsAStatementOfItsOwn) {
  EXPECT_THAT(in_condition("svc.t.op()"), ElementsAre("service_call"));
  EXPECT_THAT(in_condition("par.a and svc['t'].op(1)"), ElementsAre("service_call"));
  EXPECT_THAT(in_function("x = svc.t.op()"), ElementsAre("service_call"));
  EXPECT_THAT(in_function("print(svc.t.op())"), ElementsAre("service_call"));
}

TEST(Check, UnknownNamesAreWhatTheScopeDoesNotHave) {
  for (const char* text : {"par.nope", "res.nope", "port.nope", "chi.Nobody", "chi.C.res.nope", "chi.C.par.nope",
                           "chi.C.var.x", "chi.b.port.p", "chi.C.port.nope", "y", "open('x')", "math.nope",
                           "math.nope(1)", "geo.nope(1)", "[x for y in []]", "svc[y].data"})
    EXPECT_THAT(in_condition(text), ElementsAre("unknown_name")) << text;
  EXPECT_THAT(in_function("x = y"), ElementsAre("unknown_name"));
  EXPECT_THAT(in_function("res.nope = 1"), ElementsAre("unknown_name"));
  EXPECT_THAT(in_function("[z for z in []]\nx = z"), ElementsAre("unknown_name"));
  EXPECT_THAT(in_function("if False:\n    y = 1\nx = y"), IsEmpty())
      << "having no value yet is a fault, not a violation";
}

TEST(Check, ReportsThePosition) {
  const State state;
  const auto errors = check("res.x = 1\nvar.s = 'äö' + nope", CodeKind::function, state.symbols);
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_EQ(errors[0].where, (SourceRange{2, 16, 2, 20}));
}

TEST(Check, LimitsTheSizeOfTheText) {
  EXPECT_THAT(in_condition(std::string(150, '(') + "1" + std::string(150, ')')), IsEmpty());
  EXPECT_THAT(in_condition(std::string(5000, '(') + "1" + std::string(5000, ')')), ElementsAre("syntax"));
  EXPECT_THAT(in_condition(std::string(5000, '-') + "1"), ElementsAre("syntax"));
  std::string nots, sums = "1", subscripts = "par.a";
  for (int i = 0; i < 3000; ++i) {
    nots += "not ";
    sums += "+1";
    subscripts += "[0]";
  }
  EXPECT_THAT(in_condition(nots + "1"), ElementsAre("syntax"));
  EXPECT_THAT(in_condition(sums), ElementsAre("syntax"));
  EXPECT_THAT(in_condition(subscripts), ElementsAre("syntax"));
  EXPECT_THAT(in_condition("'" + std::string(70'000, 'a') + "'"), ElementsAre("syntax"));
  std::string blocks;
  for (std::size_t i = 0; i < 120; ++i) blocks += std::string(i, ' ') + "if 1:\n";
  EXPECT_THAT(in_function(blocks + std::string(120, ' ') + "pass"), ElementsAre("syntax"));
}

TEST(VariableNames, AreThoseBehindVar) {
  EXPECT_THAT(variable_names("var.a = var.b + 1\nif var.c:\n    var.l[var.a].append(f'{var.d}')"),
              ElementsAre("b", "a", "c", "l", "d"));
  EXPECT_THAT(variable_names(" var.x > 1"), ElementsAre("x"));
  EXPECT_THAT(variable_names("var.x ="), IsEmpty());
}

}  // namespace
}  // namespace race::language::test
