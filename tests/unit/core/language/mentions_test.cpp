// What code mentions; R9, R19 and R21 use it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/core/language/environment.h"

namespace race::language::test {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

Mentions of(State& state, std::string_view text, CodeKind kind) {
  const auto code = compile(text, kind, state.symbols, state.table);
  EXPECT_TRUE(code) << text;
  return code->mentions();
}

TEST(Mentions, SeparatesOccurrencesLatestAndResponses) {
  State state;
  const Mentions m = of(state, "svc.t.data.x > 1 and svc.t.sample.latest or svc.t.op.error", CodeKind::condition);
  EXPECT_TRUE(m.svc);
  EXPECT_THAT(m.events, ElementsAre(0U));
  EXPECT_THAT(m.latest, ElementsAre(1U));
  EXPECT_THAT(m.responses, ElementsAre(0U));
  EXPECT_THAT(m.calls, IsEmpty());
}

TEST(Mentions, HasSlotsAndFlagsThatAreReadAndWritten) {
  State state;
  const Mentions m =
      of(state, "res.out = par.a\nvar.n += 1\nvar.log.append(chi.C.res.x)\nif chi.C or port.p: res.x = 1",
         CodeKind::function);
  EXPECT_FALSE(m.svc);
  EXPECT_THAT(m.reads, ElementsAre(State::par_a, State::var_n, State::var_log, State::child_x));
  EXPECT_THAT(m.writes, ElementsAre(State::res_out, State::res_x, State::var_n, State::var_log));
  EXPECT_THAT(m.flags, ElementsAre(State::port_p, State::child_active));
}

TEST(Mentions, OfAWholeCollectionAreAllItsSlots) {
  State state;
  EXPECT_THAT(of(state, "len(res)", CodeKind::condition).reads,
              ElementsAre(State::res_out, State::res_x, State::res_unset));
}

TEST(Mentions, OfADynamicServiceAreThoseOfAllServices) {
  State state;
  state.table.declare_event("u", "data", false);
  state.table.declare_operation("u", "op", true);
  EXPECT_THAT(of(state, "svc[par.a].data", CodeKind::condition).events, ElementsAre(0U, 2U));
  EXPECT_THAT(of(state, "svc[par.a].op.result", CodeKind::condition).responses, ElementsAre(0U, 1U, 2U));
  EXPECT_THAT(of(state, "svc[par.a].op()", CodeKind::function).calls, ElementsAre(0U, 1U, 2U));
  EXPECT_TRUE(state.table.is_open(2));  // of the services that the table does not know
  EXPECT_EQ(state.table.dynamic_operation("u", "op"), 1U);
  EXPECT_EQ(state.table.dynamic_operation("nobody", "op"), 2U);
}

// The semantics does not evaluate these conditions without an occurrence, so they must be neither true nor a fault.
TEST(Mentions, KnowTheConditionsThatNeedAnOccurrence) {
  Runner r;
  r.state.set(State::res_x, Value("text"));
  r.state.raise(State::port_p);
  r.state.deliver(0, Dict{{"x", Value(4)}});
  r.state.deliver(1, Dict{{"x", Value(4)}});
  r.state.occurrence = kNone;
  for (const char* text :
       {"svc.t.data", "svc.t.sample", "svc.t.data.x > 3", "svc.t.data.a.b < res.x", "svc.t.data and res.x",
        "svc.t.data and not port.p", "not svc.t.data", "svc.t.data.x == 1 or svc.t.sample", "False",
        "not (svc.t.data.x > 3 or port.p)", "svc.t.op.result and svc.t.data"}) {
    EXPECT_TRUE(of(r.state, text, CodeKind::condition).needs_occurrence) << text;
    EXPECT_THAT(r.condition(text), ::testing::AnyOf("False", "unknown")) << text;
  }
  for (const char* text :
       {"svc.t.sample.x > 3", "svc.t.data or port.p", "svc.t.data.latest", "not available(svc.t.data)",
        "svc.t.op.result", "not (svc.t.data and not port.p)", "True", "svc.t.data and res.x > 1",
        "svc.t.data and 1 / 0", "svc.t.data.x > res.x.y", "svc.t.data > 1 > 0"})
    EXPECT_FALSE(of(r.state, text, CodeKind::condition).needs_occurrence) << text;
}

TEST(Compile, RequiresASlotForEveryVariable) {
  State state;
  EXPECT_TRUE(check("var.other", CodeKind::condition, state.symbols).empty());
  EXPECT_FALSE(compile("var.other", CodeKind::condition, state.symbols, state.table));
}

TEST(Mentions, AddNamesThatTheTableDoesNotHave) {
  State state;
  of(state, "svc.new.go and svc.new.run.result", CodeKind::condition);
  EXPECT_NE(state.table.find_event("new", "go"), kNone);
  EXPECT_NE(state.table.find_operation("new", "run"), kNone);
  EXPECT_EQ(state.table.find_event("new", "run"), kNone);
}

}  // namespace
}  // namespace race::language::test
