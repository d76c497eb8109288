// Conditions: Kleene's three values (R2), faults (R4), and what a trace records.
#include <gtest/gtest.h>

#include "core/language/evaluate/explain.h"
#include "tests/unit/core/language/environment.h"

namespace race::language::test {
namespace {

struct Case {
  const char* text;
  const char* truth;
};

TEST(Condition, IsKleenesLogic) {
  Runner r;
  r.state.set(State::res_x, Value(1));
  for (const auto& [text, truth] : std::initializer_list<Case>{
           {"res.unset", "unknown"},
           {"res.unset > 1", "unknown"},
           {"not res.unset", "unknown"},
           {"False and res.unset", "False"},
           {"res.unset and False", "False"},
           {"res.unset and True", "unknown"},
           {"res.unset or True", "True"},
           {"True or res.unset", "True"},
           {"res.unset or False", "unknown"},
           {"not (res.unset and False)", "True"},
           {"res.unset and res.x > 5", "False"},
           {"res.unset or res.unset or res.x", "True"},
           {"2 < 1 < res.unset", "False"},
           {"res.unset < 2 < 1", "False"},
           {"not (res.unset < 2 < 1)", "True"},
           {"0 < 1 < res.unset", "unknown"},
           {"1 if res.unset else 1", "unknown"},
           {"res.unset == None", "unknown"},
           {"res.unset is None", "unknown"},
           {"res.unset in [1]", "unknown"},
           {"[res.unset]", "unknown"},
           {"{'a': res.unset}", "unknown"},
           {"len([res.unset]) == 1", "unknown"},
           {"[1, 2][res.unset]", "unknown"},
           {"f'{res.unset}' == ''", "unknown"},
           {"f'{res.unset}'", "unknown"},
           {"f'{res.x}'", "True"},
           {"[x for x in [1] if res.unset]", "unknown"},
           {"[x for x in res.unset]", "unknown"},
           {"[res.unset for x in []] == []", "True"},
           {"max(res.unset, 1)", "unknown"},
           {"'a'.find(res.unset)", "unknown"},
           {"(res.unset and 0) == 0", "True"},
           {"(res.unset or 5) == True", "True"},
           {"available(res.unset)", "False"},
           {"available(res.unset + 1)", "False"},
           {"available(res.x)", "True"},
           {"chi.C.res.x", "unknown"},
           {"chi.C", "False"},
           {"res", "True"},
       })
    EXPECT_EQ(r.condition(text), truth) << text;
}

TEST(Condition, AFaultWinsOverUnknown) {
  Runner r;
  EXPECT_EQ(r.condition("res.unset + 1 // 0"), "fault zero_division");
  EXPECT_EQ(r.condition("1 // 0 + res.unset"), "fault zero_division");
  EXPECT_EQ(r.condition("res.unset and 1 // 0"), "fault zero_division");
  EXPECT_EQ(r.condition("[res.unset, [][0]]"), "fault missing");
  EXPECT_EQ(r.condition("max(res.unset, 'a' + 1)"), "fault type");
  EXPECT_EQ(r.condition("available([][0])"), "fault missing");
  EXPECT_EQ(r.condition("False and 1 // 0"), "False") << "what is not evaluated is no fault";
  EXPECT_EQ(r.condition("res.unset > 1 // 0 or True"), "fault zero_division");
  EXPECT_EQ(r.condition("1 // 0 if res.unset else 1"), "unknown");
}

TEST(Condition, AnEventByItselfAsksForItsOccurrence) {
  Runner r;
  EXPECT_EQ(r.condition("svc.t.data"), "unknown");
  EXPECT_EQ(r.condition("available(svc.t.data)"), "False");
  r.state.deliver(0, Value(Dict{{"x", Value(0)}}));
  EXPECT_EQ(r.condition("svc.t.data"), "True");
  EXPECT_EQ(r.condition("svc.t.data.x"), "False") << "a deeper path is data";
  EXPECT_EQ(r.condition("svc.t.data == {'x': 0}"), "True");
  EXPECT_EQ(r.condition("svc.t.data.y"), "fault missing");
  EXPECT_EQ(r.condition("svc.t.data.y > 3"), "fault missing");
  EXPECT_EQ(r.condition("svc.t.data.x in 3"), "fault type");
  r.state.deliver(0, Value(0));
  EXPECT_EQ(r.condition("svc.t.data and not svc.t.data == 1"), "True") << "present, whatever its data";
  EXPECT_EQ(r.condition("1 if svc.t.data else 0"), "True") << "wherever a truth is asked for";
  EXPECT_EQ(r.condition("[x for x in [1] if svc.t.data]"), "True");
  r.state.occurrence = kNone;
  EXPECT_EQ(r.condition("svc.t.data"), "unknown") << "the occurrence is of one macro step";
  EXPECT_EQ(r.condition("svc.t.data == 0"), "unknown");
  EXPECT_EQ(r.condition("svc.t.data.latest == 0"), "True");
}

TEST(Condition, DataOfASampledEventStays) {
  Runner r;
  r.state.deliver(1, Value(Dict{{"x", Value(3)}}));
  r.state.occurrence = kNone;
  EXPECT_EQ(r.condition("svc.t.sample"), "unknown");
  EXPECT_EQ(r.condition("available(svc.t.sample)"), "False");
  EXPECT_EQ(r.condition("svc.t.sample.x == 3"), "True");
  EXPECT_EQ(r.condition("available(svc.t.sample.x)"), "True");
}

TEST(Condition, AResponseIsLatched) {
  Runner r;
  EXPECT_EQ(r.condition("svc.t.op.result"), "unknown");
  r.state.answer(0, false, Value());
  EXPECT_EQ(r.condition("svc.t.op.result"), "True") << "present, although it is None";
  EXPECT_EQ(r.condition("svc.t.op.result is None"), "True");
  EXPECT_EQ(r.condition("svc.t.op.error"), "unknown");
  r.state.answer(0, true, Value(Dict{{"code", Value("x")}}));
  EXPECT_EQ(r.condition("svc.t.op.error.code == 'x'"), "True");
}

TEST(Condition, NamesAServiceByValue) {
  Runner r;
  r.state.set(State::par_a, Value("t"));
  r.state.deliver(0, Value(Dict{{"x", Value(4)}}));
  EXPECT_EQ(r.condition("svc[par.a].data.x == 4 and svc[par.a].data"), "True");
  EXPECT_EQ(r.condition("svc['nobody'].data"), "unknown");
  EXPECT_EQ(r.condition("svc[par.a].op.result"), "unknown");
  r.state.answer(0, false, Value(7));
  EXPECT_EQ(r.condition("svc[par.a].op.result == 7"), "True");
  EXPECT_EQ(r.condition("svc[1].data"), "fault type");
  EXPECT_EQ(r.condition("svc[res.unset].data"), "unknown");
}

TEST(Condition, ResultOfAKnownEventIsAField) {
  Runner r;
  r.state.deliver(0, Value(Dict{{"result", Value(1)}}));
  EXPECT_EQ(r.condition("svc.t.data.result == 1"), "True");
}

TEST(Expression, GivesAValueUnknownOrAFault) {
  Runner r;
  r.state.set(State::par_a, Value(2));
  EXPECT_EQ(r.expression("[x * par.a for x in range(3)]"), "[0,2,4]");
  EXPECT_EQ(r.expression("par"), R"({"a":2})");
  EXPECT_EQ(r.expression("res"), "{}") << "values that are set";
  EXPECT_EQ(r.expression("res.unset"), "unknown");
  EXPECT_EQ(r.expression("par.nope"), ": unknown_name: nope is not declared here");
  EXPECT_EQ(r.expression("math.inf"), "fault value") << "cannot be stored";
  EXPECT_EQ(r.expression("[math.nan]"), "fault value");
  EXPECT_EQ(r.expression("chi.C.name"), "\"C\"");
  r.state.raise(State::child_active);
  EXPECT_EQ(r.expression("[chi.C, chi.C.active, chi.b]"), "[true,true,false]");
}

class TextTrace final : public EvaluationTrace {
 public:
  void atom(bool service, Truth value, SourceRange where) override {
    text +=
        (service ? "BD" : "BE") + std::to_string(static_cast<int>(value)) + "@" + std::to_string(where.column) + " ";
  }
  void statement(bool service, SourceRange where) override {
    text += (service ? "SD@" : "ST@") + std::to_string(where.line) + " ";
  }
  void required_event(EventId event) override { text += "event" + std::to_string(event) + " "; }
  void required_response(OperationId operation, std::string_view, bool error) override {
    text += (error ? "error" : "result") + std::to_string(operation) + " ";
  }
  std::string text;
};

TEST(Trace, RecordsAtomsInOrderWithWhatTheyRequire) {
  Runner r;
  TextTrace trace;
  r.state.trace = &trace;
  r.state.deliver(0, Value(Dict{{"x", Value(4)}}));
  EXPECT_EQ(r.condition("not (chi.C or svc.t.data.x < 3) and (1 < 2 or res.unset)"), "True");
  EXPECT_EQ(trace.text, "BE0@6 event0 BD0@15 BE1@38 ") << "what is passed over is not traced";
  trace.text.clear();
  EXPECT_EQ(r.condition("svc.t.op.error or svc.t.data"), "True");
  EXPECT_EQ(trace.text, "error0 BD2@1 event0 BD1@19 ");
}

TEST(Trace, RecordsNothingOfAnExplanation) {
  Runner r;
  TextTrace trace;
  r.state.trace = &trace;
  const Code code = r.code("chi.C", CodeKind::condition);
  EXPECT_EQ(explain(code, r.state).value, Truth::no);
  EXPECT_EQ(trace.text, "");
  r.interpreter.condition(code, r.state);
  EXPECT_EQ(trace.text, "BE0@1 ") << "but what comes after it";
}

TEST(Trace, RecordsStatementsButNotCalls) {
  Runner r;
  TextTrace trace;
  r.state.trace = &trace;
  r.state.deliver(0, Value(1));
  EXPECT_EQ(r.function("x = 1\nsvc.t.op(x)\nif x:\n    svc.t.op(2)\nres.x = svc.t.data"), "");
  EXPECT_EQ(trace.text, "ST@1 SD@3 SD@5 event0 ");
  EXPECT_EQ(r.state.calls.size(), 2U);
}

}  // namespace
}  // namespace race::language::test
