// Documents from and to JSON: nothing is lost, and each violation of the shape has its path and code.
#include "core/rcm/document.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/core/rcm/cases.h"

namespace race::rcm {
namespace {

using testing::ElementsAre;

constexpr const char* kEverything = R"json({
  "rcm": 1, "name": "all", "services": {"robot": "robot", "gripper": "wsg50"},
  "library": [
    {"state": "Grasp", "parameters": [{"name": "width"}, {"name": "force", "value": null}],
     "ports": [{"name": "done", "when": "True"}]}],
  "root": {
    "state": "Root", "doc": "the task",
    "parameters": [{"name": "n", "value": [1, 2.0], "type": {"list": "number"}, "unit": "m", "doc": "d", "meta": {"min": 0}}],
    "results": [{"name": "r", "initial": {"a": 1}, "type": "any", "meta": {"id": "r1"}}, {"name": "q"}],
    "variables": [{"name": "v", "initial": null}, {"name": "w"}],
    "entry": "pass", "exit": "res.r = 1",
    "actions": [{"when": "True", "do": "var.v = 1", "meta": 7}],
    "children": [
      {"barrier": "b", "to": ["A"], "meta": {"id": "b1"}},
      {"state": "A", "parameters": [{"name": "p", "from": "par.n"}], "keep": ["out"],
       "ports": [{"name": "out", "when": "True", "to": "B", "meta": {"id": "p1"}}], "meta": {"id": "a1"}},
      {"state": "B", "link": "Grasp", "parameters": [{"name": "width", "value": 1}], "ports": [{"name": "done", "to": "A"}]},
      {"state": "C", "keep": true, "children": [{"state": "X"}],
       "oracle": {"kind": "expr", "expr": "'X'"}},
      {"state": "D", "first": "X", "children": [{"state": "X"}],
       "oracle": {"kind": "external", "call": "svc.O.d(par)"}},
      {"state": "E", "first": "X", "children": [{"state": "X"}], "ports": [{"name": "h", "when": "svc.t.hit"}],
       "oracle": {"kind": "history", "resume": ["h"]}}],
    "first": "b"},
  "layout": {"Root/A": {"x": 40, "y": 80.5}}, "meta": [1]})json";

TEST(ReadDocument, ReadsEveryField) {
  const auto document = read_document_text(kEverything);
  ASSERT_TRUE(document) << to_string(document.error().front());
  EXPECT_EQ(document->services.at("gripper"), "wsg50");
  const State& root = document->root;
  EXPECT_EQ(root.parameters[0].value, Value(List{1, 2.0}));
  EXPECT_EQ(root.parameters[0].type, Value(Dict{{"list", "number"}}));
  EXPECT_EQ(document->library[0].parameters[0].value, std::nullopt);
  EXPECT_EQ(document->library[0].parameters[1].value, Value()) << "null is a value";
  EXPECT_EQ(root.results[1].initial, std::nullopt);
  EXPECT_EQ(root.actions[0].code, "var.v = 1");
  EXPECT_EQ(name_of(root.children[0]), "b");
  EXPECT_EQ(std::get<Barrier>(root.children[0]).to, std::vector<std::string>{"A"});
  EXPECT_EQ(std::get<State>(root.children[1]).keep->ports, std::vector<std::string>{"out"});
  EXPECT_TRUE(std::get<State>(root.children[3]).keep->any);
  EXPECT_EQ(std::get<State>(root.children[4]).oracle->text, "svc.O.d(par)");
  EXPECT_EQ(std::get<State>(root.children[5]).oracle->resume, std::vector<std::string>{"h"});
  EXPECT_EQ(document->layout.find("Root/A")->find("y")->as_number(), 80.5);
}

TEST(WriteDocument, LosesNothing) {
  const Value json = parse_json(kEverything).value();
  EXPECT_EQ(write_document(read_document(json).value()), json);
}

TEST(WriteDocument, HasTheFormsOfKeep) {
  for (const char* keep : {"true", "[]", "[\"p\"]", "{\"deep\":true}", "{\"deep\":true,\"ports\":[\"p\"]}"}) {
    const std::string text =
        std::string(R"({"rcm":1,"root":{"state":"R","ports":[{"name":"p","when":"True"}],"keep":)") + keep + "}}";
    const auto document = read_document_text(text);
    ASSERT_TRUE(document) << to_string(document.error().front());
    EXPECT_EQ(to_json(write_document(*document)), text);
  }
}

TEST(WriteDocument, HasItsFieldsInOneOrder) {
  const auto document =
      read_document_text(R"({"root": {"ports": [], "doc": "d", "state": "R"}, "name": "n", "rcm": 1})");
  EXPECT_EQ(to_json(write_document(document.value())), R"({"rcm":1,"name":"n","root":{"state":"R","doc":"d"}})");
}

TEST(WriteDocument, PutsTheIdFirst) {
  const auto document =
      read_document_text(R"({"rcm": 1, "root": {"state": "R", "meta": {"icon": "hand", "id": "r"}}})");
  EXPECT_EQ(document->root.meta, (Meta{"r", Dict{{"icon", "hand"}}}));
  EXPECT_EQ(to_json(write_document(document.value())),
            R"({"rcm":1,"root":{"state":"R","meta":{"id":"r","icon":"hand"}}})");
}

TEST(ReadDraft, KeepsWhatHasTheRightShapeDespiteViolations) {
  const Draft draft =
      read_draft(parse_json(R"({"rcm": 1, "root": {"state": "R", "first": "Nobody", "entry": "while"}})").value());
  EXPECT_TRUE(draft.errors.empty());
  EXPECT_EQ(draft.document.root.first, "Nobody");
}

std::set<std::string> rejected_text(std::string_view text) {
  const auto document = read_document_text(text);
  return document ? std::set<std::string>{} : pairs(document.error());
}

/// Violations of a document whose root R has these fields besides its name.
std::set<std::string> rejected_root(const std::string& fields) {
  return rejected_text(R"({"rcm": 1, "root": {"state": "R", )" + fields + "}}");
}

TEST(ReadDocument, RejectsWhatIsNoJson) {
  EXPECT_THAT(rejected_text("{"), ElementsAre(": json"));
  EXPECT_THAT(rejected_text(R"({"rcm": 1, "rcm": 1})"), ElementsAre(": json"));
  EXPECT_THAT(rejected_text(std::string(100, '[')), ElementsAre(": too_deep"));
  EXPECT_THAT(rejected_text(std::string(17 << 20, ' ')), ElementsAre(": too_large"));
}

TEST(ReadDocument, RejectsAnotherVersionOrShape) {
  EXPECT_THAT(rejected_text("[]"), ElementsAre(": type"));
  EXPECT_THAT(rejected_text(R"({"rcm": 1.0, "root": {"state": "R"}})"), ElementsAre(": version"));
  EXPECT_THAT(rejected_text(R"({"root": {"state": "R"}})"), ElementsAre(": version"));
  EXPECT_THAT(rejected_text(R"({"rcm": 1})"), ElementsAre(": missing"));
  EXPECT_THAT(rejected_text(R"({"rcm": 1, "root": []})"), ElementsAre("?: type"));
  EXPECT_THAT(rejected_text(R"({"rcm": 1, "root": {"state": "R"}, "services": {"a": 1}})"), ElementsAre(": type"));
  EXPECT_THAT(rejected_text(R"({"rcm": 1, "root": {"state": "R"}, "layout": 1})"), ElementsAre(": type"));
}

TEST(ReadDocument, RejectsNodesWithoutName) {
  EXPECT_THAT(rejected_text(R"({"rcm": 1, "root": {}})"), ElementsAre("?: missing"));
  EXPECT_THAT(rejected_root(R"("children": [{"state": 5}])"), ElementsAre("R/?: type"));
  EXPECT_THAT(rejected_root(R"("children": [{"state": ""}])"), ElementsAre("R/?: name"));
  EXPECT_THAT(rejected_root(R"("children": [5])"), ElementsAre("R: type"));
  EXPECT_THAT(rejected_root(R"("ports": [{"when": "True"}])"), ElementsAre("R.?: missing"));
  EXPECT_THAT(rejected_text(R"({"rcm": 1, "library": [{}], "root": {"state": "R"}})"),
              ElementsAre("library/?: missing"));
}

TEST(ReadDocument, RejectsMissingFields) {
  EXPECT_THAT(rejected_root(R"("parameters": [{"value": 1}])"), ElementsAre("R: missing"));
  EXPECT_THAT(rejected_root(R"("results": [{}])"), ElementsAre("R: missing"));
  EXPECT_THAT(rejected_root(R"("actions": [{"do": "pass"}])"), ElementsAre("R: missing"));
  EXPECT_THAT(rejected_root(R"("ports": [{"name": "p"}])"), ElementsAre("R.p: missing"));
  EXPECT_THAT(rejected_root(R"("children": [{"barrier": "b"}])"), ElementsAre("R/b: missing"));
  EXPECT_THAT(rejected_root(R"("oracle": {})"), ElementsAre("R: missing"));
}

TEST(ReadDocument, RejectsWrongTypes) {
  for (const auto* fields : {R"("doc": 1)", R"("entry": null)", R"("first": 1)", R"("link": [])", R"("parameters": {})",
                             R"("parameters": [1])", R"("parameters": [{"name": "p", "type": "float"}])",
                             R"("keep": false)", R"("keep": [1])", R"("oracle": "expr")", R"("results": [{"name": 1}])",
                             R"("actions": ["pass"])", R"("oracle": {"kind": "history", "resume": true})"})
    EXPECT_THAT(rejected_root(fields), testing::Contains("R: type")) << fields;
  EXPECT_THAT(rejected_root(R"("ports": [{"name": "p", "when": true}])"), testing::Contains("R.p: type"));
}

TEST(ReadDocument, RejectsUnknownFieldsWithTheirPath) {
  EXPECT_THAT(rejected_root(R"("x": 1)"), ElementsAre("R: unknown_field"));
  EXPECT_THAT(rejected_root(R"("parameters": [{"name": "p", "initial": 1}])"), ElementsAre("R: unknown_field"));
  EXPECT_THAT(rejected_root(R"("ports": [{"name": "p", "when": "True", "do": ""}])"),
              ElementsAre("R.p: unknown_field"));
  EXPECT_THAT(rejected_root(R"("children": [{"barrier": "b", "to": [], "ports": []}])"),
              ElementsAre("R/b: unknown_field"));
  EXPECT_THAT(rejected_root(R"("children": [{"state": "s", "barrier": "b"}])"), ElementsAre("R/s: unknown_field"));
  EXPECT_THAT(rejected_text(R"({"rcm": 1, "library": [{"state": "L", "x": 1}], "root": {"state": "R"}})"),
              ElementsAre("library/L: unknown_field"));
}

TEST(ReadDocument, RejectsConstantsOutOfRange) {
  EXPECT_THAT(rejected_root(R"("parameters": [{"name": "p", "value": [{"a": 9223372036854775808}]}])"),
              ElementsAre("R: constant"));
  EXPECT_THAT(rejected_root(R"("variables": [{"name": "v", "initial": -9223372036854775809}])"),
              ElementsAre("R: constant"));
  EXPECT_THAT(rejected_root(R"("meta": 9223372036854775808)"), ElementsAre("R: constant"));
  EXPECT_THAT(rejected_root(R"("parameters": [{"name": "p", "value": 1e999}])"), ElementsAre(": constant"));
}

TEST(ReadDocument, RejectsWhatIsNoId) {
  for (const std::string& id : {std::string("7"), std::string("null"), std::string("\"\""), std::string("\"a b\""),
                                '"' + std::string(65, 'x') + '"'})
    EXPECT_THAT(rejected_root(R"("meta": {"id": )" + id + "}"), ElementsAre("R: type")) << id;
  EXPECT_THAT(rejected_root(R"("ports": [{"name": "p", "when": "True", "meta": {"id": 1}}])"),
              ElementsAre("R.p: type"));
  EXPECT_THAT(rejected_root(R"("children": [{"barrier": "b", "to": [], "meta": {"id": 1}}])"),
              ElementsAre("R/b: type"));
  const auto document = read_document_text(R"({"rcm": 1, "root": {"state": "R", "meta": {"id": "."}}})");
  EXPECT_THAT(document.error().front().message, testing::HasSubstr("`meta.id`"));
}

TEST(ReadDocument, TakesElementsWithOneIdAndTheDocumentsOwnMetaAsItIs) {
  EXPECT_THAT(rejected_text(R"({"rcm": 1, "meta": {"id": "any text"},
                           "root": {"state": "R", "meta": {"id": "x"}, "results": [{"name": "r", "meta": {"id": "x"}}]}})"),
              testing::IsEmpty());
}

TEST(ReadDocument, ListsAllViolationsAtOnce) {
  EXPECT_THAT(rejected_root(R"("doc": 1, "x": 1, "first": "N", "children": [{"state": "1"}, {}])"),
              ElementsAre("R/1: name", "R/?: missing", "R: first", "R: type", "R: unknown_field"));
}

}  // namespace
}  // namespace race::rcm
