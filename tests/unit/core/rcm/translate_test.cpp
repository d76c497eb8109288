// Translation: what links (3.3.1) and oracles (3.3.2, Fig. 3.10) become, and where each element came from.
#include "core/rcm/translate.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/rcm/document.h"
#include "core/rcm/extent.h"
#include "core/rcm/ids.h"
#include "core/rcm/library.h"
#include "tests/unit/core/rcm/cases.h"

namespace race::rcm {
namespace {

using Origin = std::map<std::string, std::string>;

NativeModel native(std::string_view document) { return translate(read_document_text(document).value()).value(); }

NativeModel native_case(const std::string& name) {
  return native(read_text(RACE_SOURCE_DIR "/tests/conformance/" + name + "/model.json"));
}

State child(const State& state, std::string_view name) {
  for (const Node& node : state.children) {
    if (name_of(node) == name) return std::get<State>(node);
  }
  throw std::out_of_range("no child " + std::string(name));
}

/// A state as JSON; the test fails with both texts where they differ.
void expect_state(const State& state, std::string_view json) {
  EXPECT_EQ(to_json(write_state(state), 1), to_json(parse_json(json).value(), 1));
}

TEST(Link, TakesOverEverythingButExpressionsAndDestinations) {
  const NativeModel model = native_case("link");
  expect_state(child(model.root, "First"), R"json({
    "state": "First",
    "parameters": [{"name": "width", "value": 0.05}, {"name": "force", "from": "par.f"}],
    "results": [{"name": "w"}],
    "entry": "svc.gripper.grasp(par.width, par.force)",
    "actions": [{"when": "svc.gripper.grasp.result", "do": "res.w = svc.gripper.grasp.result"}],
    "ports": [{"name": "success", "when": "available(res.w) and res.w > 0", "to": "Done"},
              {"name": "error", "when": "available(res.w) and res.w <= 0", "to": "Second"}]})json");
  EXPECT_EQ(child(model.root, "Second").parameters[0].value, Value(1));
  EXPECT_EQ(child(model.root, "Second").ports[1].to, std::nullopt);
}

TEST(Link, OfALinkedLibraryStateIsFollowed) {
  const NativeModel model = native_case("link-nested");
  EXPECT_EQ(model.root.name, "Root");
  EXPECT_EQ(model.root.parameters[0].value, Value(5));
  EXPECT_EQ(child(model.root, "B").entry, "res.y = par.x * 2");
  EXPECT_EQ(child(model.root, "B").parameters[0].from, "chi.A.res.y");
  EXPECT_EQ(model.origin, (Origin{{"Root", "Root"},
                                  {"Root.done", "library/Twice.done"},
                                  {"Root/A", "library/Twice/A"},
                                  {"Root/A.done", "library/Twice/A.done"},
                                  {"Root/B", "library/Twice/B"},
                                  {"Root/B.done", "library/Leaf.done"}}));
}

TEST(Link, ToALinkTakesTheNearestExpression) {
  const NativeModel model = native(R"({"rcm": 1, "library": [
      {"state": "Inner", "parameters": [{"name": "a", "value": 1}, {"name": "b", "value": 1}, {"name": "c", "value": 1}]},
      {"state": "Outer", "link": "Inner", "parameters": [{"name": "a", "value": 2}, {"name": "b", "value": 2}]}],
    "root": {"state": "R", "link": "Outer", "parameters": [{"name": "a", "value": 3}, {"name": "b"}]}})");
  EXPECT_EQ(model.root.parameters[0].value, Value(3));
  EXPECT_EQ(model.root.parameters[1].value, Value(2)) << "a parameter without expression overrides none";
  EXPECT_EQ(model.root.parameters[2].value, Value(1));
}

TEST(Link, KeepsItsOwnMetaBeforeTheLibrarys) {
  const NativeModel model = native(R"({"rcm": 1, "library": [
      {"state": "L", "doc": "of L", "meta": {"id": "l", "icon": "hand"},
       "parameters": [{"name": "p", "value": 1, "unit": "m", "meta": {"id": "lp", "min": 0}}],
       "ports": [{"name": "q", "when": "True", "meta": {"id": "lq"}}]}],
    "root": {"state": "R", "link": "L", "meta": {"id": "r"}, "parameters": [{"name": "p", "value": 2, "meta": {"id": "rp"}}],
             "ports": [{"name": "q", "meta": {"id": "rq"}}]}})");
  expect_state(model.root, R"({"state": "R", "doc": "of L",
    "parameters": [{"name": "p", "value": 2, "unit": "m", "meta": {"id": "rp", "min": 0}}],
    "ports": [{"name": "q", "when": "True", "meta": {"id": "rq"}}], "meta": {"id": "r", "icon": "hand"}})");
}

TEST(ExprOracle, BecomesADispatcherInFrontOfTheChildren) {
  const State task = child(native_case("oracle-expr").root, "Task");
  EXPECT_EQ(task.first, "Dispatcher");
  EXPECT_EQ(name_of(task.children.front()), "Dispatcher");
  EXPECT_EQ(task.children.size(), 4U);
  EXPECT_EQ(task.keep, std::nullopt);
  expect_state(child(task, "Dispatcher"), R"({
    "state": "Dispatcher", "parameters": [{"name": "choice", "from": "par.entry"}],
    "ports": [{"name": "to_A", "when": "par.choice == 'A'", "to": "A"},
              {"name": "to_B", "when": "par.choice == 'B'", "to": "B"},
              {"name": "to_C", "when": "par.choice == 'C'", "to": "C"},
              {"name": "otherwise", "when": "available(par.choice) and par.choice not in ['A', 'B', 'C']", "to": "A"}]})");
}

TEST(ExprOracle, WithoutFirstHasNoOtherwiseAndLeadsToStatesOnly) {
  const NativeModel model = native(R"({"rcm": 1, "root": {"state": "R", "oracle": {"kind": "expr", "expr": "'A'"},
      "children": [{"barrier": "b", "to": ["A"]}, {"state": "A"}]}})");
  ASSERT_EQ(child(model.root, "Dispatcher").ports.size(), 1U);
  EXPECT_EQ(child(model.root, "Dispatcher").ports[0].name, "to_A");
}

TEST(ExternalOracle, CallsOnEntryWithArgumentsOfTheComposite) {
  expect_state(child(child(native_case("oracle-external").root, "Task"), "Dispatcher"), R"json({
    "state": "Dispatcher",
    "parameters": [{"name": "arg0", "from": "par"}, {"name": "arg1", "from": "res"}, {"name": "arg2", "from": "var"},
                   {"name": "arg3", "from": "'x'"}],
    "results": [{"name": "choice"}],
    "entry": "svc.O.decide(par.arg0, par.arg1, par.arg2, par.arg3)",
    "actions": [{"when": "svc.O.decide.result", "do": "res.choice = svc.O.decide.result"}],
    "ports": [{"name": "to_A", "when": "res.choice == 'A'", "to": "A"},
              {"name": "to_B", "when": "res.choice == 'B'", "to": "B"},
              {"name": "to_C", "when": "res.choice == 'C'", "to": "C"},
              {"name": "otherwise",
               "when": "svc.O.decide.error or (available(res.choice) and res.choice not in ['A', 'B', 'C'])",
               "to": "A"}]})json");
}

TEST(ExternalOracle, CountsKeywordsOn) {
  const NativeModel model = native(R"json({"rcm": 1, "root": {"state": "R", "first": "A", "children": [{"state": "A"}],
      "oracle": {"kind": "external", "call": "svc.O.decide(1, where=var)"}}})json");
  EXPECT_EQ(child(model.root, "Dispatcher").entry, "svc.O.decide(par.arg0, where=par.arg1)");
  EXPECT_EQ(child(model.root, "Dispatcher").parameters[1].from, "var");
}

TEST(HistoryOracle, RemembersTheChildAndKeeps) {
  expect_state(child(native_case("oracle-history-resume").root, "Task"), R"({
    "state": "Task",
    "variables": [{"name": "last_active", "initial": "M"}],
    "actions": [{"when": "chi.M.active and var.last_active != 'M'", "do": "var.last_active = 'M'"},
                {"when": "chi.G.active and var.last_active != 'G'", "do": "var.last_active = 'G'"}],
    "children": [
      {"state": "Dispatcher", "parameters": [{"name": "choice", "from": "var.last_active"}],
       "ports": [{"name": "to_M", "when": "par.choice == 'M'", "to": "M"},
                 {"name": "to_G", "when": "par.choice == 'G'", "to": "G"},
                 {"name": "otherwise", "when": "available(par.choice) and par.choice not in ['M', 'G']", "to": "M"}]},
      {"state": "M", "ports": [{"name": "m", "when": "svc.t.go", "to": "G"}]},
      {"state": "G", "ports": [{"name": "g", "when": "svc.t.go"}]}],
    "first": "Dispatcher",
    "ports": [{"name": "collision", "when": "svc.t.hit", "to": "Handle"},
              {"name": "done", "when": "chi.G.port.g", "to": "Rest"}],
    "keep": ["collision"]})");
  EXPECT_TRUE(child(native_case("oracle-history").root, "Task").keep->any) << "without `resume`, through any port";
}

TEST(HistoryOracle, FollowsTheCompositesOwnVariablesAndActions) {
  const NativeModel model = native(R"({"rcm": 1, "root": {"state": "R", "first": "A", "children": [{"state": "A"}],
      "variables": [{"name": "v"}], "actions": [{"when": "False", "do": "pass"}], "oracle": {"kind": "history"}}})");
  EXPECT_EQ(model.root.variables[1].name, "last_active");
  EXPECT_EQ(model.root.actions[0].when, "False");
}

// What is accepted can be read back from a journal, whose native model is held against the same limits.
TEST(Translate, MakesNothingThatTheExtentOfTheDocumentDoesNotCount) {
  for (const auto& folder : cases(false)) {
    const auto document = read_document_text(read_text(folder / "model.json"));
    ASSERT_TRUE(document) << folder;
    Document native;
    native.root = translate(*document)->root;
    const Extent counted = extent_of(*document, Library(*document)), made = extent_of(native, Library(native));
    EXPECT_LE(made.states, counted.states) << folder;
    EXPECT_LE(made.bytes, counted.bytes) << folder;
    EXPECT_LE(made.depth, counted.depth) << folder;
  }
}

TEST(DeepHistory, MakesTheCompositesInsideGoOnWhenTheyWereLeftWithTheirParent) {
  const NativeModel model = native_case("oracle-history-deep");
  const State task = child(model.root, "Task");
  EXPECT_EQ(task.keep, (Keep{.ports = {"hit"}, .deep = true}));
  const State pick = child(task, "Pick");
  EXPECT_EQ(pick.keep, (Keep{.ports = {}, .deep = true})) << "the library state that a link takes over, too";
  EXPECT_EQ(pick.first, "Dispatcher");
  EXPECT_EQ(pick.variables.front().initial, Value("Approach"));
  EXPECT_EQ(child(pick, "Grasp").keep, pick.keep);
  EXPECT_EQ(model.origin.at("Root/Task/Pick/Grasp/Dispatcher"), "library/Pick/Grasp");
  EXPECT_EQ(child(task, "Place").keep, std::nullopt) << "without children there is nothing to go on with";
}

TEST(DeepHistory, EndsAtStatesThatSayOtherwise) {
  const State apart = child(child(child(native_case("oracle-history-deep").root, "Task"), "Pick"), "Approach");
  EXPECT_EQ(apart.first, "Up");
  EXPECT_EQ(apart.keep, (Keep{.ports = {}})) << "a `keep` of its own";
  const State task = child(native_case("oracle-history-deep-inside").root, "Task");
  EXPECT_EQ(child(task, "Steps").keep, (Keep{.ports = {"err"}, .deep = true})) << "a history inside is deep";
  EXPECT_EQ(child(child(task, "Steps"), "B").first, "Dispatcher");
  EXPECT_EQ(child(task, "Chosen").keep, std::nullopt) << "another oracle";
  EXPECT_EQ(child(task, "Fork").first, "Begin") << "a barrier as first";
  EXPECT_EQ(child(task, "Later").first, "Alone") << "a barrier that leads to several";
}

TEST(DeepHistory, LeavesTheSameLibraryStateElsewhereAsItIs) {
  const NativeModel model = native(R"({"rcm": 1, "library": [
      {"state": "L", "first": "A", "children": [{"state": "A"}]}],
    "root": {"state": "R", "first": "In", "children": [{"state": "Out", "link": "L"},
      {"state": "In", "first": "I", "children": [{"state": "I", "link": "L"}], "oracle": {"kind": "history", "deep": true}}]}})");
  EXPECT_EQ(child(model.root, "Out").first, "A");
  EXPECT_EQ(child(child(model.root, "In"), "I").first, "Dispatcher");
}

TEST(After, OfOnePortIsTheFirstStateWhereThereIsNone) {
  const NativeModel model = native_case("after");
  expect_state(child(model.root, "Ask"), R"json({
    "state": "Ask",
    "parameters": [{"name": "timeout", "from": "1.5 + var.rounds"}],
    "children": [{"state": "After_late", "parameters": [{"name": "seconds", "from": "par.timeout", "unit": "s"}],
                  "variables": [{"name": "tries", "initial": 1}], "entry": "svc.timer.wait(par.seconds)",
                  "actions": [{"when": "svc.timer.wait.error.code == 'unavailable' and var.tries < 10",
                               "do": "var.tries += 1\nsvc.timer.wait(par.seconds)"},
                              {"when": "svc.timer.wait.error.code != 'unavailable'",
                               "do": "int('time-out: ' + svc.timer.wait.error.code)"}],
                  "ports": [{"name": "due", "when": "svc.timer.wait.result"}]}],
    "first": "After_late",
    "ports": [{"name": "late", "when": "chi.After_late.port.due", "to": "Ask"},
              {"name": "done", "when": "svc.person.done", "to": "End"}]})json");
  EXPECT_EQ(model.origin.at("Root/Ask/After_late"), "library/Patient.late");
  EXPECT_EQ(model.origin.at("Root/Ask/After_late.due"), "library/Patient.late");
}

TEST(After, BesideAFirstStateIsReachedByABarrier) {
  const NativeModel model = native_case("after-first");
  const auto barrier = [&](std::string_view state) {
    const State at = child(model.root, state);
    EXPECT_EQ(at.first, "After");
    return std::get<Barrier>(at.children.back()).to;
  };
  EXPECT_EQ(barrier("Pause"), (std::vector<std::string>{"Step", "After_over"}));
  EXPECT_EQ(barrier("Work"), (std::vector<std::string>{"Left", "Right", "After_soon", "After_late"}))
      << "a first barrier's targets";
  EXPECT_EQ(barrier("Choose"), (std::vector<std::string>{"Dispatcher", "After_over"}));
  EXPECT_EQ(child(child(model.root, "Choose"), "Dispatcher").ports.size(), 2u) << "it does not choose what waits";
  EXPECT_EQ(model.origin.at("Root/Work/After"), "Root/Work");
}

TEST(After, HasIdsOfItsPort) {
  const auto ids = [](const std::string& port) {
    const State root = native(R"({"rcm": 1, "root": {"state": "R", "meta": {"id": "r"}, "first": "A",
        "children": [{"state": "A"}], "ports": [{"name": ")" +
                              port + R"(", "after": "1", "meta": {"id": "p"}}]}})")
                           .root;
    const State& wait = std::get<State>(root.children[1]);
    return std::vector<std::string>{wait.meta.id, wait.parameters[0].meta.id, wait.ports[0].meta.id,
                                    std::get<Barrier>(root.children[2]).meta.id};
  };
  EXPECT_THAT(ids("p"), testing::Each(testing::SizeIs(13)));
  EXPECT_EQ(ids("p"), ids("renamed"));
}

TEST(Oracle, OfALibraryStateIsTranslatedAtEachLink) {
  const NativeModel model = native(R"({"rcm": 1,
    "library": [{"state": "L", "children": [{"state": "X"}], "oracle": {"kind": "expr", "expr": "'X'"}}],
    "root": {"state": "R", "children": [{"state": "A", "link": "L"}, {"state": "B", "link": "L"}]}})");
  EXPECT_EQ(child(child(model.root, "B"), "Dispatcher").ports[0].to, "X");
  EXPECT_EQ(model.origin.at("R/B"), "R/B");
  EXPECT_EQ(model.origin.at("R/B/X"), "library/L/X");
  EXPECT_EQ(model.origin.at("R/B/Dispatcher"), "library/L");
  EXPECT_EQ(model.origin.at("R/B/Dispatcher.to_X"), "library/L");
}

/// The link's meta, and that of its parameter, in the native model.
State linked(const std::string& library_meta, const std::string& link_meta) {
  return native(R"({"rcm": 1, "library": [{"state": "L", "meta": )" + library_meta +
                R"(, "parameters": [{"name": "p", "value": 1, "meta": )" + library_meta +
                R"(}]}], "root": {"state": "R", "link": "L", "meta": )" + link_meta +
                R"(, "parameters": [{"name": "p", "meta": )" + link_meta + "}]}}")
      .root;
}

TEST(Link, WithOnlyAnIdKeepsTheMetaOfTheLibraryThatIsNoObject) {
  const State state = linked("[7]", R"({"id": "r"})");
  EXPECT_EQ(state.meta, (Meta{"r", Dict{{"value", List{7}}}}));
  EXPECT_EQ(state.parameters[0].meta, state.meta);
}

TEST(Link, WhoseMetaIsNoObjectKeepsTheDerivedId) {
  const State state = native(R"({"rcm": 1,
      "library": [{"state": "L", "parameters": [{"name": "p", "value": 1, "meta": {"id": "lp", "icon": "x"}}]}],
      "root": {"state": "R", "link": "L", "meta": {"id": "r"}, "parameters": [{"name": "p", "meta": [7]}]}})")
                          .root;
  EXPECT_EQ(state.parameters[0].meta, (Meta{derived_id("r", "lp"), Dict{{"value", List{7}}}}));
}

TEST(Link, WithoutAnIdHasNotTheLibrarys) { EXPECT_EQ(linked(R"({"id": "l"})", "[7]").meta, (Meta{"", List{7}})); }

constexpr const char* kLinks = R"json({"rcm": 1, "library": [
    {"state": "Leaf", "meta": {"id": "leaf"}, "parameters": [{"name": "a", "value": 1, "meta": {"id": "la"}},
                                                           {"name": "b", "value": 1, "meta": {"id": "lb"}}],
     "results": [{"name": "r", "meta": {"id": "lr"}}], "variables": [{"name": "v", "meta": {"id": "lv"}}],
     "actions": [{"when": "True", "do": "pass", "meta": {"id": "lx"}}],
     "ports": [{"name": "p", "when": "True", "meta": {"id": "lp"}}, {"name": "q", "when": "True", "meta": {"id": "lq"}}]},
    {"state": "Twice", "meta": {"id": "twice"}, "children": [
      {"state": "A", "link": "Leaf", "meta": {"id": "ta"}, "ports": [{"name": "p", "to": "b", "meta": {"id": "tp"}}]},
      {"barrier": "b", "to": [], "meta": {"id": "tb"}}]}],
  "root": {"state": "R", "meta": {"id": "r"}, "children": [
    {"state": "One", "link": "Leaf", "meta": {"id": "one"}, "parameters": [{"name": "a", "value": 2, "meta": {"id": "oa"}}],
     "ports": [{"name": "q", "meta": {"id": "oq"}}]},
    {"state": "Two", "link": "Twice", "meta": {"id": "two"}}]}})json";

TEST(NativeIds, OfWhatALinkTakesOverAreDerivedFromItsOwn) {
  const State one = child(native(kLinks).root, "One");
  EXPECT_EQ(one.meta.id, "one");
  EXPECT_EQ(one.parameters[0].meta.id, "oa") << "the link declares it";
  EXPECT_EQ(one.parameters[1].meta.id, derived_id("one", "lb"));
  EXPECT_EQ(one.results[0].meta.id, derived_id("one", "lr"));
  EXPECT_EQ(one.variables[0].meta.id, derived_id("one", "lv"));
  EXPECT_EQ(one.actions[0].meta.id, derived_id("one", "lx"));
  EXPECT_EQ(one.ports[0].meta.id, derived_id("one", "lp"));
  EXPECT_EQ(one.ports[1].meta.id, "oq");
}

TEST(NativeIds, OfNestedLinksNest) {
  const State two = child(native(kLinks).root, "Two");
  EXPECT_EQ(std::get<Barrier>(two.children[1]).meta.id, derived_id("two", "tb"));
  const State a = child(two, "A");
  EXPECT_EQ(a.meta.id, derived_id("two", "ta"));
  EXPECT_EQ(a.ports[0].meta.id, derived_id("two", "tp"));
  EXPECT_EQ(a.ports[1].meta.id, derived_id(derived_id("two", "ta"), "lq"));
}

void collect_ids(const State& state, std::vector<std::string>& out) {
  const auto add = [&](const auto& elements) {
    for (const auto& element : elements) out.push_back(element.meta.id);
  };
  out.push_back(state.meta.id);
  add(state.parameters);
  add(state.results);
  add(state.variables);
  add(state.actions);
  add(state.ports);
  for (const Node& node : state.children) {
    if (const auto* inner = std::get_if<State>(&node)) {
      collect_ids(*inner, out);
    } else {
      out.push_back(std::get<Barrier>(node).meta.id);
    }
  }
}

std::vector<std::string> native_ids(const Document& document) {
  std::vector<std::string> out;
  collect_ids(translate(document).value().root, out);
  return out;
}

TEST(NativeIds, OfWhatAnOracleBecomesSurviveRenames) {
  const auto renamed = [](std::string_view composite, std::string_view first, std::string_view oracle) {
    const std::string x(first);
    return read_document_text(R"({"rcm": 1, "root": {"state": "R", "meta": {"id": "r"}, "children": [{"state": ")" +
                              std::string(composite) + R"(", "meta": {"id": "c"}, "first": ")" + x +
                              R"(", "children": [{"state": ")" + x +
                              R"(", "meta": {"id": "x"}}, {"state": "Y", "meta": {"id": "y"}}], "oracle": )" +
                              std::string(oracle) + "}]}}")
        .value();
  };
  for (const char* oracle : {R"({"kind": "expr", "expr": "'Y'"})", R"({"kind": "history"})",
                             R"json({"kind": "external", "call": "svc.o.decide(1, 2)"})json"}) {
    const auto ids = native_ids(renamed("C", "X", oracle));
    EXPECT_EQ(native_ids(renamed("Other", "First", oracle)), ids) << oracle;
    EXPECT_EQ(std::set<std::string>(ids.begin(), ids.end()).size(), ids.size()) << oracle;
    EXPECT_TRUE(std::ranges::all_of(ids, is_id)) << oracle;
  }
}

TEST(NativeIds, OfTheOracleOfALinkedStateAreDerivedFromTheLinks) {
  const NativeModel model = native(R"({"rcm": 1, "library": [
      {"state": "L", "meta": {"id": "l"}, "first": "X", "children": [{"state": "X", "meta": {"id": "x"}}],
       "oracle": {"kind": "history"}},
      {"state": "M", "link": "L", "meta": {"id": "m"}}],
    "root": {"state": "R", "children": [{"state": "A", "link": "L", "meta": {"id": "a"}},
                                        {"state": "B", "link": "M", "meta": {"id": "b"}}]}})");
  for (const auto& [name, id] : {std::pair("A", "a"), std::pair("B", "b")}) {
    const State link = child(model.root, name);
    EXPECT_EQ(link.meta.id, id);
    EXPECT_EQ(child(link, "X").meta.id, derived_id(id, "x")) << "a link to a link, too";
    EXPECT_EQ(child(link, "Dispatcher").meta.id, derived_id(id, ":dispatcher"));
    EXPECT_EQ(link.variables[0].meta.id, derived_id(id, ":last_active"));
  }
}

/// All ids of states, and that each is there once.
void expect_different(const std::vector<std::string>& ids) {
  EXPECT_EQ(std::set<std::string>(ids.begin(), ids.end()).size(), ids.size()) << testing::PrintToString(ids);
}

TEST(NativeIds, AreUniqueIfNativeElementsWerePastedIntoTheDocument) {
  const std::string replaced = derived_id(derived_id("a", "x"), ":1");
  for (const auto& pasted : {std::vector{derived_id("a", "x")}, std::vector{derived_id("a", "x"), replaced},
                             std::vector{derived_id("a", ":dispatcher"), derived_id("a", "x")}}) {
    Document document = read_document_text(R"({"rcm": 1,
        "library": [{"state": "L", "meta": {"id": "l"}, "children": [{"state": "X", "meta": {"id": "x"}}],
                     "oracle": {"kind": "expr", "expr": "'X'"}}],
        "root": {"state": "R", "meta": {"id": "r"}, "children": [{"state": "A", "link": "L", "meta": {"id": "a"}}]}})")
                            .value();
    for (const std::string& id : pasted) {
      State copy;
      copy.name = "P" + id;
      copy.meta.id = id;
      document.root.children.emplace_back(copy);
    }
    const auto ids = native_ids(document);
    expect_different(ids);
    EXPECT_TRUE(std::ranges::all_of(ids, is_id));
    for (const std::string& id : pasted) EXPECT_EQ(std::ranges::count(ids, id), 1) << "the document's own stay";
    EXPECT_EQ(native_ids(document), ids);
  }
}

TEST(NativeIds, AreAllDifferentAndNoneWithoutThoseOfTheDocument) {
  for (const auto& folder : cases(false)) {
    Document document = read_document_text(read_text(folder / "model.json")).value();
    if (document.root.meta.id.empty()) {
      for (const std::string& id : native_ids(document)) EXPECT_EQ(id, "") << folder;
    }
    give_ids(document);
    const auto ids = native_ids(document);
    EXPECT_EQ(std::set<std::string>(ids.begin(), ids.end()).size(), ids.size()) << folder;
    EXPECT_TRUE(std::ranges::all_of(ids, is_id)) << folder;
  }
}

TEST(NativeIds, AreNoneBelowALinkThatHasNone) {
  const Document document = read_document_text(R"({"rcm": 1,
      "library": [{"state": "L", "meta": {"id": "l"}, "children": [{"state": "X", "meta": {"id": "x"}}]}],
      "root": {"state": "R", "children": [{"state": "A", "link": "L"}]}})")
                                .value();
  EXPECT_EQ(native_ids(document), (std::vector<std::string>{"", "", ""})) << "else two links would have the same";
}

TEST(Translation, LeavesADocumentWithoutExtensionsAsItIs) {
  const auto document =
      read_document_text(read_text(RACE_SOURCE_DIR "/tests/conformance/barrier-join/model.json")).value();
  const NativeModel model = translate(document).value();
  EXPECT_EQ(model.root, document.root);
  for (const auto& [path, origin] : model.origin) EXPECT_EQ(path, origin);
}

}  // namespace
}  // namespace race::rcm
