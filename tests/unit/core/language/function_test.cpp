// Functions: assignment by value, places, calls, being unmet, and faults.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/core/language/environment.h"

namespace race::language::test {
namespace {

using ::testing::ElementsAre;

TEST(Function, AssignmentCopies) {
  Runner r;
  EXPECT_EQ(r.out("a = [1]\nb = a\nb.append(2)\nres.out = [a, b]"), "[[1],[1,2]]");
  EXPECT_EQ(r.out("a = [[0]] * 2\na[0][0] = 1\nres.out = a"), "[[1],[0]]");
  EXPECT_EQ(r.out("var.n = {'k': []}\nd = var.n\nd.k.append(1)\nres.out = [var.n, d]"), R"([{"k":[]},{"k":[1]}])");
  EXPECT_EQ(r.out("a = [1, 2]\na.append(a)\nres.out = a"), "[1,2,[1,2]]");
  EXPECT_EQ(r.out("l = [1, 2]\nfor x in l:\n    l.append(x)\nres.out = l"), "[1,2,1,2]")
      << "a loop runs over what was there";
  EXPECT_EQ(r.out("a = [1, 2]\nres.out = a + [a.pop()]"), "[1,2,2]") << "operands are values, from left to right";
  EXPECT_EQ(r.out("a = [[1]]\nres.out = [a[0], a.pop(), a]"), "[[1],[1],[]]");
}

TEST(Function, ChangesPlaces) {
  Runner r;
  EXPECT_EQ(r.out("res.out = [1, {'a': [2]}]\nres.out[1].a[0] += 5\nres.out[1]['b'] = 3\nres.out[1].a.extend('xy')"),
            R"([1,{"a":[7,"x","y"],"b":3}])");
  EXPECT_EQ(r.out("res.out = [3, 1, 2]\nres.out.sort(reverse=True)\nres.out[-1] *= 10"), "[3,2,10]");
  EXPECT_EQ(r.out("i = 0\na = [0, 0]\ni, a[i] = 1, 5\nres.out = a"), "[0,5]") << "targets get their values in order";
  EXPECT_EQ(r.out("a = b = []\na.append(1)\nres.out = [a, b]"), "[[1],[]]");
  EXPECT_EQ(r.out("x = [1]\nx += x\nx *= 2\nres.out = x"), "[1,1,1,1]");
  EXPECT_EQ(r.out("(a, b), c = 'xy', 1\n[d, e] = [a, b]\nres.out = [e, d, c]"), R"(["y","x",1])");
  EXPECT_EQ(r.out("res.out = sorted([2, 1]).pop()"), "2") << "a temporary value may be changed";
  EXPECT_EQ(r.out("d = {'a': 1, 'b': 2}\nres.out = [d.pop('a'), d]"), R"([1,{"b":2}])");
  EXPECT_EQ(r.out("d = {}\nd['a'] += 1 // 0"), "fault missing") << "what is changed is looked up before the value";
}

TEST(Function, HasControlFlow) {
  Runner r;
  EXPECT_EQ(
      r.out("s = 0\nfor i in range(10):\n    if i == 3: continue\n    if i == 6: break\n    s += i\nres.out = [s, i]"),
      "[12,6]");
  EXPECT_EQ(r.out("n = 0\nwhile True:\n    n += 1\n    if n > 4: break\nres.out = n"), "5");
  EXPECT_EQ(r.out("res.out = []\nfor k, v in {'a': 1, 'b': 2}.items():\n    res.out.append(k * v)"), R"(["a","bb"])");
  EXPECT_EQ(r.out("x = 5\ny = [x for x in range(3)]\nres.out = [x, y]"), "[5,[0,1,2]]")
      << "a comprehension has names of its own";
  EXPECT_EQ(r.out("x = [1, 2]\nres.out = [x for x in x]"), "[1,2]") << "what it runs over is named outside of it";
  EXPECT_EQ(r.out("for i in range(3): pass\nres.out = i"), "2");
  EXPECT_EQ(r.out("if 0: a = 1\nelif 1: a = 2\nelse: a = 3\nres.out = a"), "2");
}

TEST(Function, CallsOperationsInOrder) {
  Runner r;
  r.state.set(State::par_a, Value("t"));
  EXPECT_EQ(r.function("svc.t.op(1 + 1, [2], speed=0.5)\nfor i in range(2):\n    svc[par.a].other(i)\nsvc.t.op()"), "");
  EXPECT_THAT(r.state.calls, ElementsAre(R"(t.op[2,[2]]{"speed":0.5})", "t.other[0]{}", "t.other[1]{}", "t.op[]{}"));
  EXPECT_EQ(r.function("svc.t.op(math.inf)"), "fault value");
  EXPECT_EQ(r.function("svc[1].op()"), "fault type");
}

TEST(Function, IsUnmetAtTheFirstUseOfUnknown) {
  Runner r;
  EXPECT_EQ(r.function("x = res.unset"), "unmet");
  EXPECT_EQ(r.function("x = svc.t.data.x + 1 // 0"), "unmet") << "before the fault";
  EXPECT_EQ(r.function("x = 1 // 0 + res.unset"), "fault zero_division");
  EXPECT_EQ(r.function("x = True or res.unset"), "") << "what is not evaluated is not used";
  EXPECT_EQ(r.function("x = res.unset or True"), "unmet");
  EXPECT_EQ(r.function("if svc.t.data: pass"), "unmet");
  EXPECT_EQ(r.function("res.unset += 1"), "unmet");
  EXPECT_EQ(r.function("res.unset.append(1)"), "unmet");
  EXPECT_EQ(r.function("svc.t.op(res.unset)"), "unmet");
  EXPECT_EQ(r.function("x = svc['nobody'].op.result"), "unmet");
  EXPECT_EQ(r.interpreter.fault().where, (SourceRange{1, 5, 1, 28}));
  EXPECT_EQ(r.out("res.out = [available(res.unset), available(svc.t.data.x + 1), available(svc.t.op.error)]"),
            "[false,false,false]");
  EXPECT_EQ(r.function("if not available(res.unset) and res.unset: pass"), "unmet");
}

TEST(Function, FaultsHaveAMessageAndAPosition) {
  Runner r;
  for (const auto& [text, fault] : std::initializer_list<std::pair<const char*, const char*>>{
           {"res.x = 1 + 'a'", "fault type"},
           {"d = {'a': 1}\nres.x = d['b']", "fault missing"},
           {"res.x = [1, 2][2]", "fault missing"},
           {"res.x = {}.a", "fault missing"},
           {"res.x = (5).a", "fault type"},
           {"x = 5\nx.append(1)", "fault type"},
           {"res.x = 1 // 0", "fault zero_division"},
           {"res.x = 9223372036854775807 + 1", "fault overflow"},
           {"res.x = 2.0 ** 5000", "fault overflow"},
           {"res.x = int('abc')", "fault value"},
           {"a, b = [1]", "fault value"},
           {"if False:\n    y = 1\nres.x = y", "fault name"},
           {"if False:\n    y = []\ny.append(1)", "fault name"},
           {"if False:\n    y = 1\ny += 1", "fault name"},
           {"x = {1: 2}", "fault type"},
           {"x = {}\nx[1] = 2", "fault type"},
           {"x = len()", "fault type"},
           {"x = len(1, 2)", "fault type"},
           {"x = 'a'.find()", "fault type"},
           {"x = round(1, ndigits=2, number=3)", "fault type"},
           {"x = available()", "fault type"},
           {"res.x = math.nan", "fault value"},
           {"res.x = [1.5, {'a': [math.inf]}]", "fault value"},
           {"x = math.inf - math.inf\nprint(x)", ""},
           {"for x in 5: pass", "fault type"},
       })
    EXPECT_EQ(r.function(text), fault) << text;
  r.function("x = 1\nres.x = x +\\\n  'a'");
  EXPECT_EQ(r.interpreter.fault().where, (SourceRange{2, 9, 3, 6}));
  EXPECT_EQ(r.interpreter.fault().message, "unsupported operand type(s) for +: 'int' and 'str'");
  r.function("x = [1, 2]\nres.x = 1 + x[2]");
  EXPECT_EQ(r.interpreter.fault().where, (SourceRange{2, 13, 2, 17})) << "an index and what it is taken of";
  r.function("res.x = {'a': 1, 2: 3}");
  EXPECT_EQ(r.interpreter.fault().where, (SourceRange{1, 18, 1, 19})) << "the key";
}

TEST(Budget, CountsEvaluatedNodes) {
  const auto runs_with = [](std::uint64_t steps, const char* text) {
    Runner r(Interpreter::Limits{.steps = steps});
    return r.function(text);
  };
  // block, assignment, sum, two constants
  EXPECT_EQ(runs_with(5, "x = 1 + 2"), "");
  EXPECT_EQ(runs_with(4, "x = 1 + 2"), "fault budget");
  EXPECT_EQ(runs_with(1000, "while True:\n    pass"), "fault budget");
  EXPECT_EQ(Runner().function("n = 0\nfor i in range(200000):\n    pass"), "");
  EXPECT_EQ(Runner().function("for i in range(999000):\n    pass"), "fault budget");
  Runner r(Interpreter::Limits{.steps = 4});
  r.state.deliver(0, Value(Dict{{"x", Value(4)}}));
  EXPECT_EQ(r.condition("svc.t.data.x > 3"), "True");
  EXPECT_EQ(r.condition("svc.t.data.x > 3 + 1"), "fault budget");
  Runner less(Interpreter::Limits{.steps = 3});
  less.state.deliver(0, Value(Dict{{"x", Value(4)}}));
  EXPECT_EQ(less.condition("svc.t.data.x > 3"), "fault budget") << "however fast it is decided";
  EXPECT_EQ(less.condition("chi.C or port.p"), "False");
  EXPECT_EQ(less.condition("not (chi.C or port.p)"), "fault budget") << "and, or, not count";
  EXPECT_EQ(less.condition("not (True and True)"), "fault budget");
}

TEST(Budget, BoundsTheSizeOfValues) {
  Runner r;
  for (const char* text : {"x = 'a' * 1000000",
                           "x = 'a' * 999999 * 999999999",
                           "x = 'abcd' * 4611686018427387904",
                           "x = [0] * 1000001",
                           "x = list(range(1000000))",
                           "for i in range(1000001): pass",
                           "x = 'a'\nwhile True: x += x",
                           "x = [1]\nwhile True: x = [x, x]",
                           "x = [1]\nwhile True: x.append(x)",
                           "x = [1]\nfor i in range(60): x.insert(0, x)",
                           "x = {'a': 1}\nwhile True: x['a'] = [x, x]",
                           "x = [1]\nwhile True: x = [x]",
                           "x = {}\nwhile True: x = {'k': x}",
                           "x = 'abcdefgh' * 100000\ny = x.replace('', x)",
                           "x = 'a'.center(1000000000)",
                           "x = f'{1:1000000000}'",
                           "x = f'{1.5:.1000000000f}'",
                           "x = ','.join(['a' * 900000] * 2)",
                           "x = [0] * 600000\nx += x",
                           "x = 'ß' * 400000\ny = x + x",
                           "x = [0] * 400000\ny = enumerate(x)"})
    EXPECT_EQ(r.function(text), "fault budget") << text;
  Runner large(Interpreter::Limits{.steps = 10'000'000});
  EXPECT_EQ(large.function("x = [0] * 999999\nres.x = x"), "");
  EXPECT_EQ(r.function("x = 'a' * 999998\nres.x = x"), "");
}

TEST(Print, GoesToTheEnvironment) {
  Runner r;
  EXPECT_EQ(r.function("print('a', 1, [2.0, None], sep='-', end='!')\nlog('b')\nprint()"), "");
  EXPECT_EQ(r.state.printed, "a-1-[2.0, None]!b\n\n");
}

}  // namespace
}  // namespace race::language::test
