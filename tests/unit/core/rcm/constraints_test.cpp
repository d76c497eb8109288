// The constraints on documents: for each code, documents that violate it, with the path, and similar valid ones.
#include "core/rcm/constraints.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/rcm/translate.h"
#include "tests/unit/core/rcm/cases.h"

namespace race::rcm {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::set<std::string> rejected(const std::string& root, const std::string& library = "") {
  const auto document = read_document_text(R"({"rcm": 1, "library": [)" + library + R"(], "root": )" + root + "}");
  return document ? std::set<std::string>{} : pairs(document.error());
}

std::string message(const std::string& root, const std::string& library = "") {
  const auto document = read_document_text(R"({"rcm": 1, "library": [)" + library + R"(], "root": )" + root + "}");
  return document ? "" : document.error().front().message;
}

/// Violations of a root P with these children.
std::set<std::string> rejected_children(const std::string& children) {
  return rejected(R"({"state": "P", "children": [)" + children + "]}");
}

/// Violations of a child O of P with children X, Y and a barrier b, and these further fields.
std::set<std::string> rejected_oracle(const std::string& fields) {
  return rejected_children(R"({"state": "O", "ports": [{"name": "stop", "when": "svc.t.stop"}],
    "children": [{"state": "X"}, {"state": "Y"}, {"barrier": "b", "to": ["X"]}], )" +
                           fields + "}");
}

constexpr const char* kGrasp =
    R"json({"state": "Grasp", "parameters": [{"name": "width", "value": 1}, {"name": "force"}],
  "results": [{"name": "w"}], "ports": [{"name": "done", "when": "available(res.w)"}]})json";

// Structure

TEST(Names, MatchTheFormat) {
  EXPECT_THAT(rejected(R"({"state": "a b"})"), ElementsAre("a b: name"));
  EXPECT_THAT(rejected(R"({"state": "P", "parameters": [{"name": "1"}]})"), ElementsAre("P: name"));
  EXPECT_THAT(rejected(R"({"state": "P", "results": [{"name": ""}]})"), ElementsAre("P: name"));
  EXPECT_THAT(rejected(R"({"state": "P", "variables": [{"name": "a-b"}]})"), ElementsAre("P: name"));
  EXPECT_THAT(rejected(R"({"state": "P", "ports": [{"name": "a.b", "when": "True"}]})"), ElementsAre("P.a.b: name"));
  EXPECT_THAT(rejected_children(R"({"barrier": "1", "to": []})"), ElementsAre("P/1: name"));
  EXPECT_THAT(rejected(R"({"state": "P"})", R"({"state": "1"})"), ElementsAre("library/1: name"));
  EXPECT_THAT(rejected(R"({"state": "_P1"})"), IsEmpty());
  const auto service = read_document_text(R"({"rcm": 1, "services": {"a b": "x"}, "root": {"state": "P"}})");
  EXPECT_THAT(pairs(service.error()), ElementsAre(": name"));
}

TEST(Names, AreDeclaredOnceOfTheirKind) {
  EXPECT_THAT(rejected(R"({"state": "P", "parameters": [{"name": "a"}, {"name": "a"}]})"), ElementsAre("P: duplicate"));
  EXPECT_THAT(rejected(R"({"state": "P", "ports": [{"name": "a", "when": "True"}, {"name": "a", "when": "True"}]})"),
              ElementsAre("P: duplicate"));
  EXPECT_THAT(rejected_children(R"({"state": "A"}, {"barrier": "A", "to": []})"), ElementsAre("P: duplicate"));
  EXPECT_THAT(rejected(R"({"state": "P"})", R"({"state": "L"}, {"state": "L"})"), ElementsAre(": duplicate"));
  EXPECT_THAT(rejected(R"({"state": "P", "parameters": [{"name": "a", "value": 1}], "results": [{"name": "a"}]})"),
              IsEmpty());
}

TEST(First, NamesAChild) {
  EXPECT_THAT(rejected(R"({"state": "P", "first": "A"})"), ElementsAre("P: first"));
  EXPECT_THAT(rejected(R"({"state": "P", "first": "P", "children": [{"state": "A"}]})"), ElementsAre("P: first"));
  EXPECT_THAT(rejected(R"({"state": "P", "first": "b", "children": [{"barrier": "b", "to": []}]})"), IsEmpty());
}

TEST(PortTarget, IsASibling) {
  const auto to = [](const std::string& target) {
    return rejected_children(R"({"state": "A", "ports": [{"name": "p", "when": "True", "to": ")" + target + R"("}],
      "children": [{"state": "Deep"}]}, {"barrier": "b", "to": ["A"]})");
  };
  EXPECT_THAT(to("A"), IsEmpty());
  EXPECT_THAT(to("b"), IsEmpty());
  EXPECT_THAT(to("Deep"), ElementsAre("P/A.p: port_target"));
  EXPECT_THAT(to("P"), ElementsAre("P/A.p: port_target"));
}

TEST(PortTarget, IsNoneForTheRootAndForLibraryStates) {
  const auto* state = R"({"state": "P", "ports": [{"name": "p", "when": "True", "to": "P"}]})";
  EXPECT_THAT(rejected(state), ElementsAre("P.p: port_target"));
  EXPECT_THAT(rejected(R"({"state": "R"})", state), ElementsAre("library/P.p: port_target"));
}

TEST(BarrierTarget, IsASiblingState) {
  EXPECT_THAT(rejected_children(R"({"barrier": "b", "to": ["N"]})"), ElementsAre("P/b: barrier_target"));
  EXPECT_THAT(rejected_children(R"({"barrier": "b", "to": ["b"]})"), ElementsAre("P/b: barrier_target"));
}

TEST(Parameters, HaveAValueOrAnExpression) {
  EXPECT_THAT(rejected_children(R"({"state": "A", "parameters": [{"name": "a", "value": 1, "from": "1"}]})"),
              ElementsAre("P/A: parameter"));
}

TEST(Parameters, OfTheRootHaveNoExpression) {
  EXPECT_THAT(rejected(R"({"state": "P", "parameters": [{"name": "a", "from": "1"}]})"), ElementsAre("P: root_from"));
  EXPECT_THAT(
      rejected(R"({"state": "P", "link": "L"})", R"({"state": "L", "parameters": [{"name": "a", "from": "1"}]})"),
      ElementsAre("P: root_from"))
      << "also where a link takes it over";
  EXPECT_THAT(rejected(R"({"state": "P", "link": "L", "parameters": [{"name": "a", "value": 1}]})",
                       R"({"state": "L", "parameters": [{"name": "a", "from": "1"}]})"),
              IsEmpty());
}

TEST(Keep, NamesPortsOfTheState) {
  EXPECT_THAT(rejected(R"({"state": "P", "keep": ["p"]})"), ElementsAre("P: keep"));
  EXPECT_THAT(rejected(R"({"state": "P", "keep": ["p"], "ports": [{"name": "p", "when": "True"}]})"), IsEmpty());
}

// Links

TEST(Link, LeadsToALibraryState) {
  EXPECT_THAT(rejected_children(R"({"state": "A", "link": "P"})"), ElementsAre("P/A: link_unknown"));
  EXPECT_THAT(rejected(R"({"state": "P"})", R"({"state": "L", "children": [{"state": "A", "link": "N"}]})"),
              ElementsAre("library/L/A: link_unknown"));
}

TEST(Link, HasNoBehaviourOfItsOwn) {
  for (const auto* field :
       {R"("entry": "pass")", R"("exit": "pass")", R"("results": [{"name": "x"}])", R"("variables": [{"name": "x"}])",
        R"("actions": [{"when": "True", "do": "pass"}])", R"("children": [{"state": "X"}])", R"("first": "X")",
        R"("keep": true)", R"("oracle": {"kind": "expr", "expr": "1"})"})
    EXPECT_THAT(rejected(R"({"state": "P", "link": "Grasp", )" + std::string(field) + "}", kGrasp),
                ElementsAre("P: link_field"))
        << field;
  EXPECT_THAT(rejected(R"({"state": "P", "link": "Grasp", "doc": "d", "meta": 1})", kGrasp), IsEmpty());
}

TEST(Link, OverridesWhatTheLibraryStateHas) {
  EXPECT_THAT(rejected(R"({"state": "P", "link": "Grasp", "parameters": [{"name": "w", "value": 1}]})", kGrasp),
              ElementsAre("P: link_parameter"));
  EXPECT_THAT(rejected(R"({"state": "P", "link": "Grasp", "ports": [{"name": "w"}]})", kGrasp),
              ElementsAre("P.w: link_port"));
  EXPECT_THAT(rejected(R"({"state": "P", "link": "L", "parameters": [{"name": "force", "value": 1}]})",
                       std::string(R"({"state": "L", "link": "Grasp"}, )") + kGrasp),
              IsEmpty())
      << "through links of links";
}

TEST(LinkCycle, IsReportedAtItsFirstStateWithItsNames) {
  const auto* library = R"({"state": "Use", "link": "Y"}, {"state": "X", "children": [{"state": "A", "link": "Y"}]},
                           {"state": "Y", "link": "X"})";
  EXPECT_THAT(rejected(R"({"state": "P", "link": "X"})", library), ElementsAre("library/X: link_cycle"));
  EXPECT_EQ(message(R"({"state": "P"})", library), "links in a circle: X -> Y -> X");
  EXPECT_EQ(message(R"({"state": "P"})", R"({"state": "W", "link": "W"})"), "links in a circle: W -> W");
}

TEST(LinkCycle, IsNotALinkFromTwoPlaces) {
  EXPECT_THAT(rejected(R"({"state": "P", "children": [{"state": "A", "link": "X"}, {"state": "B", "link": "Y"}]})",
                       R"({"state": "X", "link": "Y"}, {"state": "Y"})"),
              IsEmpty());
}

TEST(Extent, OfLinksThatMultiplyIsBounded) {
  std::string library = R"({"state": "L0"})";
  for (int i = 1; i < 40; ++i) {
    const std::string link = R"("link": "L)" + std::to_string(i - 1) + "\"}";
    library += R"(, {"state": "L)" + std::to_string(i) + R"(", "children": [{"state": "A", )" + link +
               R"(, {"state": "B", )" + link + "]}";
  }
  EXPECT_THAT(rejected(R"({"state": "P", "link": "L39"})", library), ElementsAre(": too_large"));
}

TEST(Extent, OfTextThatLinksMultiplyIsBounded) {
  const std::string library = R"({"state": "L", "doc": ")" + std::string(1 << 20, ' ') + "\"}";
  std::string children;
  const auto root = [&] { return R"({"state": "P", "children": [)" + children + "]}"; };
  for (int i = 0; i < 60; ++i)
    children += (i == 0 ? "" : ", ") + std::string(R"({"state": "A)") + std::to_string(i) + R"(", "link": "L"})";
  EXPECT_THAT(rejected(root(), library), IsEmpty());
  for (int i = 60; i < 70; ++i) children += R"(, {"state": "A)" + std::to_string(i) + R"(", "link": "L"})";
  EXPECT_THAT(rejected(root(), library), ElementsAre(": too_large"));
}

TEST(Extent, CountsWhatADeepHistoryMakes) {
  std::string groups;
  for (int i = 0; i < 40; ++i) {
    groups += (i == 0 ? "" : ", ") + std::string(R"({"state": "G)") + std::to_string(i) +
              R"(", "first": "C0", "children": [)";
    for (int k = 0; k < 1000; ++k)
      groups += (k == 0 ? "" : ", ") + std::string(R"({"state": "C)") + std::to_string(k) +
                R"(", "first": "L", "children": [{"state": "L"}]})";
    groups += "]}";
  }
  const std::string root = R"({"state": "P", "first": "G0", "children": [)" + groups + "]";
  EXPECT_THAT(rejected(root + "}", ""), IsEmpty()) << "80041 states";
  EXPECT_THAT(rejected(root + R"(, "oracle": {"kind": "history"}})", ""), IsEmpty());
  EXPECT_THAT(rejected(root + R"(, "oracle": {"kind": "history", "deep": true}})", ""), ElementsAre(": too_large"))
      << "and 40041 dispatchers";
}

TEST(Extent, OfLongChainsInADeepHistoryIsBounded) {
  std::string library = R"({"state": "L0"})";
  for (int i = 1; i < 60'000; ++i)
    library += R"(, {"state": "L)" + std::to_string(i) + R"(", "first": "C", "children": [{"state": "C", "link": "L)" +
               std::to_string(i - 1) + "\"}]}";
  EXPECT_THAT(rejected(R"({"state": "P", "first": "A", "children": [{"state": "A", "link": "L59999"}],
                           "oracle": {"kind": "history", "deep": true}})",
                       library),
              ElementsAre(": too_deep"));
}

TEST(Extent, OfLongChainsIsBounded) {
  std::string library = R"({"state": "L0"})";
  for (int i = 1; i < 20'000; ++i)
    library += R"(, {"state": "L)" + std::to_string(i) + R"(", "link": "L)" + std::to_string(i - 1) + "\"}";
  EXPECT_THAT(rejected(R"({"state": "P"})", library), ElementsAre(": too_deep"));
}

TEST(Link, OfALongChainToNothingIsReportedOnceWhereItBreaks) {
  std::string library;
  for (int i = 0; i < 20'000; ++i)
    library += (i == 0 ? "" : ", ") + std::string(R"({"state": "L)") + std::to_string(i) + R"(", "link": "L)" +
               std::to_string(i + 1) + "\"}";
  EXPECT_THAT(rejected(R"({"state": "P", "link": "L0"})", library), ElementsAre("library/L19999: link_unknown"));
}

// Oracles

TEST(Oracle, NeedsWhatItsTranslationUses) {
  EXPECT_THAT(rejected_oracle(R"("oracle": {"kind": "expr", "expr": "'X'"})"), IsEmpty());
  EXPECT_THAT(rejected_oracle(R"("oracle": {"kind": "guess"})"), ElementsAre("P/O: oracle"));
  EXPECT_THAT(rejected_oracle(R"("oracle": {"kind": "history"})"), ElementsAre("P/O: oracle"));
  EXPECT_THAT(rejected_oracle(R"json("oracle": {"kind": "external", "call": "svc.O.d()"})json"),
              ElementsAre("P/O: oracle"));
  EXPECT_THAT(rejected_oracle(R"json("first": "X", "oracle": {"kind": "external", "call": "d()"})json"),
              ElementsAre("P/O: oracle"));
  EXPECT_THAT(rejected_oracle(R"("first": "b", "oracle": {"kind": "expr", "expr": "'X'"})"),
              ElementsAre("P/O: oracle"));
  EXPECT_THAT(rejected_oracle(R"("first": "X", "keep": ["stop"], "oracle": {"kind": "history"})"),
              ElementsAre("P/O: oracle"));
  EXPECT_THAT(rejected_children(R"({"state": "A", "oracle": {"kind": "expr", "expr": "1"}})"),
              ElementsAre("P/A: oracle"));
}

TEST(Oracle, ResumesThroughPortsOfTheState) {
  EXPECT_THAT(rejected_oracle(R"("first": "X", "oracle": {"kind": "history", "resume": ["stop"]})"), IsEmpty());
  EXPECT_THAT(rejected_oracle(R"("first": "X", "oracle": {"kind": "history", "resume": ["go"]})"),
              ElementsAre("P/O: keep"));
}

TEST(Oracle, RequiresTheNamesThatItAddsToBeFree) {
  EXPECT_THAT(rejected_children(R"({"state": "A", "children": [{"state": "Dispatcher"}],
                                    "oracle": {"kind": "expr", "expr": "1"}})"),
              ElementsAre("P/A: duplicate"));
  EXPECT_THAT(rejected_oracle(R"("first": "X", "variables": [{"name": "last_active"}], "oracle": {"kind": "history"})"),
              ElementsAre("P/O: duplicate"));
  EXPECT_THAT(rejected_children(R"({"state": "Dispatcher"})"), IsEmpty());
}

// Time-outs

/// A child A of the root with these fields.
std::set<std::string> rejected_child(const std::string& fields) {
  return rejected_children(R"({"state": "A", )" + fields + "}");
}

TEST(After, StandsInPlaceOfACondition) {
  EXPECT_THAT(rejected_child(R"("ports": [{"name": "p", "after": "2.5"}])"), IsEmpty());
  EXPECT_THAT(rejected_child(R"("ports": [{"name": "p", "after": "1", "when": "True"}])"), ElementsAre("P/A.p: after"));
  EXPECT_THAT(rejected_child(R"("ports": [{"name": "p"}])"), ElementsAre("P/A.p: missing"));
  EXPECT_THAT(rejected_child(R"("ports": [{"name": "p", "after": 1}])"), testing::Contains("P/A.p: type"));
}

TEST(After, OfALinkIsThatOfTheLibrary) {
  EXPECT_THAT(rejected(R"({"state": "P", "link": "L", "ports": [{"name": "p", "after": "1"}]})",
                       R"({"state": "L", "ports": [{"name": "p", "after": "2"}]})"),
              ElementsAre("P.p: after"));
}

TEST(After, IsAnExpressionInTheScopeOfItsState) {
  EXPECT_THAT(rejected_child(R"("parameters": [{"name": "t", "value": 1}],
                                "ports": [{"name": "p", "after": "par.t * 2"}])"),
              IsEmpty());
  EXPECT_THAT(rejected_child(R"("ports": [{"name": "p", "after": "par.t"}])"), ElementsAre("P/A.p: unknown_name"));
  EXPECT_THAT(rejected_child(R"("ports": [{"name": "p", "after": "1 +"}])"), ElementsAre("P/A.p: syntax"));
  EXPECT_THAT(rejected_child(R"("ports": [{"name": "p", "after": "svc.robot.seconds"}])"), ElementsAre("P/A.p: scope"));
}

TEST(After, RequiresTheNamesThatItAddsToBeFree) {
  const auto with = [](const std::string& child, const std::string& ports) {
    return rejected_child(R"("children": [{"state": ")" + child + R"("}], "ports": )" + ports);
  };
  const std::string one = R"([{"name": "p", "after": "1"}])";
  const std::string two = R"([{"name": "p", "after": "1"}, {"name": "q", "after": "2"}])";
  EXPECT_THAT(with("After_p", one), ElementsAre("P/A: duplicate"));
  EXPECT_THAT(with("After", two), ElementsAre("P/A: duplicate")) << "two states that wait need a barrier";
  EXPECT_THAT(with("After", one), IsEmpty()) << "one that waits is the first state";
}

// Code

TEST(Code, SeesWhatAfterMakes) {
  EXPECT_THAT(rejected_child(R"("ports": [{"name": "p", "after": "1"}],
                                "exit": "var.x = chi.After_p.par.seconds if chi.After_p.active else 0")"),
              IsEmpty());
}

TEST(Code, IsCheckedInEveryField) {
  EXPECT_THAT(rejected(R"({"state": "P", "entry": "x ="})"), ElementsAre("P: syntax"));
  EXPECT_THAT(rejected(R"({"state": "P", "exit": "import os"})"), ElementsAre("P: forbidden"));
  EXPECT_THAT(rejected(R"json({"state": "P", "actions": [{"when": "svc.a.b()", "do": "pass"}]})json"),
              ElementsAre("P: service_call"));
  EXPECT_THAT(rejected(R"({"state": "P", "actions": [{"when": "True", "do": "par.a = 1"}]})"),
              testing::Contains("P: scope"));
  EXPECT_THAT(rejected(R"({"state": "P", "ports": [{"name": "p", "when": "nobody"}]})"),
              ElementsAre("P.p: unknown_name"));
  EXPECT_THAT(rejected_children(R"({"state": "A", "parameters": [{"name": "a", "from": "par.b"}]})"),
              ElementsAre("P/A: unknown_name"));
  EXPECT_THAT(rejected_oracle(R"("oracle": {"kind": "expr", "expr": "par.b"})"), ElementsAre("P/O: unknown_name"));
  EXPECT_THAT(rejected_oracle(R"json("first": "X", "oracle": {"kind": "external", "call": "svc.O.d(1, par.b)"})json"),
              ElementsAre("P/O: unknown_name"));
  EXPECT_THAT(rejected(R"({"state": "P"})", R"({"state": "L", "entry": "x ="})"), ElementsAre("library/L: syntax"));
}

TEST(Code, IsNamedInTheMessage) {
  EXPECT_THAT(message(R"({"state": "P", "exit": "x ="})"), testing::StartsWith("exit: "));
  EXPECT_THAT(message(R"({"state": "P", "actions": [{"when": "True", "do": "pass"}, {"when": "True", "do": "x ="}]})"),
              testing::StartsWith("action 1, `do`: "));
}

TEST(Code, IsNamedByItsElementAndField) {
  const auto document = read_document_text(R"json({"rcm": 1, "root": {"state": "P", "meta": {"id": "s"},
    "entry": "x =", "exit": "\nx =", "first": "X", "oracle": {"kind": "external", "call": "svc.O.d(1, par.b)"},
    "actions": [{"when": "x =", "do": "x =", "meta": {"id": "a"}}],
    "ports": [{"name": "p", "when": "x =", "meta": {"id": "p"}}, {"name": "q", "after": "x =", "meta": {"id": "q"}}],
    "children": [{"state": "X", "parameters": [{"name": "f", "from": "x =", "meta": {"id": "f"}}]}]}})json");
  std::vector<std::string> texts;
  for (const Error& error : document.error())
    texts.push_back(error.id + " " + error.text + " " + std::to_string(error.where.line));
  EXPECT_THAT(texts, ElementsAre("s entry 1", "s exit 2", "a when 1", "a do 1", "s oracle 0", "f from 1", "p when 1",
                                 "q after 1"));
  EXPECT_EQ(read_document_text(R"({"rcm": 1, "root": {"state": "P", "entry": "x ="}})").error().front().id, "");
}

TEST(Code, OfAParentSeesWhatALinkTakesOver) {
  const auto with = [](const std::string& condition) {
    return rejected(R"({"state": "P", "children": [{"state": "A", "link": "Grasp"}],
                        "ports": [{"name": "p", "when": ")" +
                        condition + R"("}]})",
                    kGrasp);
  };
  EXPECT_THAT(with("chi.A.res.w and chi.A.par.force and chi.A.port.done"), IsEmpty());
  EXPECT_THAT(with("chi.A.res.x"), ElementsAre("P.p: unknown_name"));
}

TEST(Code, SeesWhatAnOracleMakes) {
  EXPECT_THAT(rejected_oracle(R"("first": "X", "oracle": {"kind": "history"},
                                 "exit": "var.x = var.last_active if chi.Dispatcher.active else chi.Dispatcher.par.choice")"),
              IsEmpty());
}

TEST(Code, OfALibraryStatesParameterHasTheScopeOfTheLink) {
  const auto* library = R"({"state": "L", "parameters": [{"name": "a", "from": "par.n"}]})";
  const auto linked_in = [&](const std::string& parameters, const std::string& link) {
    return rejected(R"({"state": "P", "parameters": [)" + parameters + R"(], "children": [{"state": "A", "link": "L")" +
                        link + "}]}",
                    library);
  };
  EXPECT_THAT(rejected(R"({"state": "P"})", library), IsEmpty());
  EXPECT_THAT(linked_in(R"({"name": "n", "value": 1})", ""), IsEmpty());
  EXPECT_THAT(linked_in("", ""), ElementsAre("P/A: unknown_name"));
  EXPECT_THAT(linked_in("", R"(, "parameters": [{"name": "a", "value": 1}])"), IsEmpty());
  EXPECT_THAT(rejected(R"({"state": "P"})", R"({"state": "L", "parameters": [{"name": "a", "from": "svc.t.x"}]})"),
              ElementsAre("library/L: scope"));
}

TEST(Code, HasItsNamesCheckedOnlyInAValidStructure) {
  EXPECT_THAT(rejected(R"({"state": "P", "first": "N", "entry": "x = nobody", "exit": "par.a = 1"})"),
              ElementsAre("P: first"));
  EXPECT_THAT(rejected(R"({"state": "P", "first": "N", "entry": "x =", "exit": "import os"})"),
              ElementsAre("P: first", "P: forbidden", "P: syntax"));
}

TEST(Violations, AreWhatTranslationReturns) {
  Document document;
  document.root.name = "P";
  document.root.first = "N";
  EXPECT_THAT(pairs(violations(document)), ElementsAre("P: first"));
  EXPECT_THAT(pairs(translate(document).error()), ElementsAre("P: first"));
}

}  // namespace
}  // namespace race::rcm
