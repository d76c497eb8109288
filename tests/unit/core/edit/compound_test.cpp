// Compound edits: what each changes in small documents, what it refuses, and that the documents of the demonstration
// keep their meaning.
#include "core/edit/compound.h"

#include <algorithm>

#include "core/edit/references.h"
#include "core/rcm/constraints.h"
#include "core/rcm/ids.h"
#include "tests/unit/core/edit/documents.h"
#include "tests/unit/core/rcm/cases.h"

namespace race::edit {
namespace {

/// A document whose elements get ids that nobody needs to write: found by their paths, `Root/A.port`.
class Model {
 public:
  explicit Model(Value json) : Model(document_of(json)) {}
  explicit Model(rcm::Document document) : tree_(Tree::read(with_ids(std::move(document))).value()) {}

  const Tree& tree() const { return tree_; }
  std::string text() const { return text_of(tree_); }

  /// An element by the names on its way from the root, or, beginning with `library`, in the library.
  std::string operator[](std::string_view path) const {
    std::string at;
    for (bool is_first = true; !path.empty(); is_first = false) {
      const std::string name(path.substr(0, path.find('/')));
      path.remove_prefix(std::min(name.size() + 1, path.size()));
      if (is_first && name != "library") {
        at = tree_.root();
        continue;
      }
      if (is_first) continue;
      at = below(at, name);
      if (at.empty()) ADD_FAILURE() << "there is no " << name;
    }
    return at;
  }

  /// Applies an edit; its inverse restores the text.
  void apply(const Expected<Edit>& edit) {
    ASSERT_TRUE(edit) << to_string(edit.error());
    EXPECT_EQ(read_edit(write_edit(*edit)).value(), *edit);
    const std::string before = text();
    Tree back = tree_;
    const auto inverse = edit::apply(tree_, *edit);
    ASSERT_TRUE(inverse) << to_string(inverse.error());
    back = tree_;
    ASSERT_TRUE(edit::apply(back, *inverse));
    ASSERT_EQ(text_of(back), before);
  }

  std::string violations() const {
    std::string out;
    for (const Error& error : rcm::violations(tree_.document())) out += to_string(error) + "\n";
    return out;
  }

  /// A field of an element, as JSON.
  std::string field(const std::string& path, std::string_view name) const {
    const std::string id = (*this)[path];
    const Value json = id.empty() ? Value() : tree_.write(id);
    const Value* found = json.find(name);
    return found ? to_json(*found) : "";
  }

 private:
  static rcm::Document with_ids(rcm::Document document) {
    rcm::give_ids(document);
    return document;
  }

  std::string below(const std::string& parent, std::string_view name) const {
    for (std::size_t list = 0; list < kListCount; ++list) {
      for (const std::string& id : tree_.list(parent, static_cast<ListName>(list))) {
        if (name_of(tree_.find(id)->content) == name) return id;
      }
    }
    return {};
  }

  Tree tree_;
};

std::string refusal(const Expected<Edit>& edit) {
  return edit ? "accepted" : edit.error().path + ": " + std::string(name(edit.error().code));
}

Model task() {
  return Model(json(R"({'rcm': 1, 'services': {'arm': 'robot'},
    'library': [{'state': 'Tool', 'parameters': [{'name': 'w', 'value': 1}], 'results': [{'name': 'got'}],
                 'entry': 'res.got = par.w', 'ports': [{'name': 'ok', 'when': 'True'}]},
                {'state': 'Alias', 'link': 'Tool', 'ports': [{'name': 'ok'}]}],
    'root': {'state': 'Root', 'first': 'A', 'keep': ['end'],
      'parameters': [{'name': 'p', 'value': 1}], 'variables': [{'name': 'v', 'initial': 0}],
      'entry': 'x = par.p\nvar.v = [par.p for q in par[\"p\"]] + [chi.A.active]  # par.p\nsvc.arm.move(par.get(\'p\', 1), f\'{par.p}\')',
      'actions': [{'when': '\'p\' in par and chi.A.res.r > 0 or chi.A', 'do': 'svc[\'arm\'].stop(chi.T.res.got)'}],
      'children': [
        {'state': 'A', 'results': [{'name': 'r'}], 'parameters': [{'name': 'a', 'from': 'par.p + var.v'}],
         'ports': [{'name': 'done', 'when': 'res.r == par.a', 'to': 'b'}]},
        {'state': 'T', 'link': 'Alias', 'parameters': [{'name': 'w', 'from': 'chi.A.res.r'}],
         'ports': [{'name': 'ok', 'to': 'A'}]},
        {'barrier': 'b', 'to': ['T', 'A']}],
      'ports': [{'name': 'end', 'when': 'chi.A.port.done and chi.T.port.ok and chi.b.active'}]}})"));
}

TEST(Rename, OfAStateChangesPortsBarriersFirstAndCode) {
  Model m = task();
  m.apply(rename(m.tree(), m["Root/A"], "Start"));
  EXPECT_EQ(m.violations(), "");
  EXPECT_EQ(m.field("Root/T/ok", "to"), "\"Start\"");
  EXPECT_EQ(m.field("Root/b", "to"), R"(["T","Start"])");
  EXPECT_EQ(m.field("Root", "first"), "\"Start\"");
  EXPECT_EQ(m.field("Root/T/w", "from"), "\"chi.Start.res.r\"");
  EXPECT_EQ(m.field("Root/end", "when"), "\"chi.Start.port.done and chi.T.port.ok and chi.b.active\"");
}

TEST(Rename, OfAParameterChangesCodeAndEntriesAndLeavesCommentsAndTexts) {
  Model m = task();
  m.apply(rename(m.tree(), m["Root/p"], "start"));
  EXPECT_EQ(m.violations(), "");
  EXPECT_EQ(m.field("Root", "entry"),
            to_json("x = par.start\nvar.v = [par.start for q in par[\"start\"]] + [chi.A.active]  # par.p\n"
                    "svc.arm.move(par.get(\"start\", 1), f\"{par.start}\")"));
  EXPECT_EQ(m.field("Root/A/a", "from"), "\"par.start + var.v\"");
}

TEST(Rename, OfWhatTheLibraryOffersChangesTheLinks) {
  Model m = task();
  m.apply(rename(m.tree(), m["library/Tool/ok"], "fine"));
  m.apply(rename(m.tree(), m["library/Tool/w"], "width"));
  m.apply(rename(m.tree(), m["library/Tool/got"], "found"));
  m.apply(rename(m.tree(), m["library/Tool"], "Gripper"));
  m.apply(rename(m.tree(), m["library/Alias"], "Hand"));
  EXPECT_EQ(m.violations(), "");
  EXPECT_EQ(m.field("Root/T/width", "from"), "\"chi.A.res.r\"");
  EXPECT_EQ(m.field("Root/T", "link"), "\"Hand\"");
}

TEST(Rename, OfPortsAndVariablesAndBarriers) {
  Model m = task();
  m.apply(rename(m.tree(), m["Root/end"], "over"));
  EXPECT_EQ(m.field("Root", "keep"), R"(["over"])");
  m.apply(rename(m.tree(), m["Root/A/done"], "ready"));
  m.apply(rename(m.tree(), m["Root/v"], "value"));
  m.apply(rename(m.tree(), m["Root/b"], "join"));
  EXPECT_EQ(m.violations(), "");
  m.apply(rename(m.tree(), m["Root"], "Task"));
}

TEST(Rename, OfAPortWithATimeOutRenamesTheStateThatWaits) {
  Model m(json(R"({'rcm': 1, 'services': {'timer': 'timer'}, 'root': {'state': 'R', 'children': [{'state': 'A'}],
    'actions': [{'when': 'chi.After_late.active and not chi.After_late.port.due', 'do': 'var.x = \'After_late\''}],
    'ports': [{'name': 'late', 'after': '2'}]}})"));
  m.apply(rename(m.tree(), m["R/late"], "slow"));
  EXPECT_EQ(m.violations(), "");
  const Value root = m.tree().write(m["R"]);
  const Value& action = root.find("actions")->as_list()[0];
  EXPECT_EQ(*action.find("when"), Value("chi.After_slow.active and not chi.After_slow.port.due"));
  EXPECT_EQ(*action.find("do"), Value("var.x = \"After_late\"")) << "a text that is no name";
  EXPECT_EQ(refusal(rename_service(m.tree(), "timer", "clock")), m["R/slow"] + ": not_accepted");
}

TEST(Rename, OfAPortLeavesAHistoryAndAKeepDeep) {
  Model m(json(R"({'rcm': 1, 'root': {'state': 'R', 'first': 'A', 'children': [
    {'state': 'A', 'keep': {'deep': true, 'ports': ['a']}, 'ports': [{'name': 'a', 'when': 'True'}]}],
    'ports': [{'name': 'hit', 'when': 'False'}], 'oracle': {'kind': 'history', 'resume': ['hit'], 'deep': true}}})"));
  m.apply(rename(m.tree(), m["R/hit"], "stop"));
  m.apply(rename(m.tree(), m["R/A/a"], "b"));
  EXPECT_EQ(m.field("R", "oracle"), R"({"kind":"history","resume":["stop"],"deep":true})");
  EXPECT_EQ(m.field("R/A", "keep"), R"({"deep":true,"ports":["b"]})");
}

TEST(Rename, OfAChildChangesTheTextsThatAnOracleChooses) {
  Model m(json(R"({'rcm': 1, 'root': {'state': 'R', 'parameters': [{'name': 'p', 'value': 1}],
    'children': [{'state': 'A'}, {'state': 'B'}],
    'oracle': {'kind': 'expr', 'expr': '\'A\' if par.p == \'A\' else [\'B\', \'A\'][par.p]'}}})"));
  m.apply(rename(m.tree(), m["R/A"], "C"));
  EXPECT_EQ(m.field("R", "oracle"), R"({"kind":"expr","expr":"\"C\" if par.p == \"A\" else [\"B\", \"C\"][par.p]"})");
}

TEST(Rename, RefusesNamesThatAreTakenOrNone) {
  Model m = task();
  EXPECT_EQ(refusal(rename(m.tree(), m["Root/A"], "b")), "name: duplicate");
  EXPECT_EQ(refusal(rename(m.tree(), m["Root/A"], "1")), "name: name");
  EXPECT_EQ(refusal(rename(m.tree(), "nobody", "x")), "id: not_found");
  EXPECT_EQ(refusal(rename(m.tree(), m.tree().list(m["Root"], ListName::actions)[0], "x")), "id: not_accepted");
  EXPECT_EQ(refusal(rename(m.tree(), m["Root/T/ok"], "x")), "id: link_port");
  EXPECT_EQ(refusal(rename(m.tree(), m["Root/T/w"], "x")), "id: link_parameter");
  EXPECT_EQ(rename(m.tree(), m["Root/A"], "A").value(), Edit{});
  m.apply(Edit{{Set{m["Root/A"], "exit", {}, Value("var.free = 1")}}});
  m.apply(Edit{{Insert{{m["Root/A"], ListName::variables, {}}, json("{'name': 'u', 'meta': {'id': 'u'}}")}}});
  EXPECT_EQ(refusal(rename(m.tree(), "u", "free")), "name: duplicate") << "an undeclared variable";
}

TEST(Rename, RefusesToMissAReferenceInATextThatCannotBeParsed) {
  Model m = task();
  m.apply(Edit{{Set{m["Root"], "exit", {}, Value("x = (par.p")}}});
  EXPECT_EQ(refusal(rename(m.tree(), m["Root/p"], "q")), m["Root"] + ": syntax");
  m.apply(rename(m.tree(), m["Root/v"], "w"));
}

/// A is a link that takes over `w` from the library, on the way through another link; B gives it an expression.
Model taken_over() {
  return Model(json(R"({'rcm': 1,
    'library': [{'state': 'L', 'parameters': [{'name': 'w', 'from': 'par.p + chi.C.res.r'},
                                              {'name': 'x', 'from': 'par.p'}]},
                {'state': 'M', 'link': 'L', 'parameters': [{'name': 'x', 'from': 'chi.C.res.s'}]}],
    'root': {'state': 'R', 'first': 'A', 'parameters': [{'name': 'p', 'value': 1}], 'children': [
      {'state': 'A', 'link': 'M'},
      {'state': 'B', 'link': 'L', 'parameters': [{'name': 'w', 'value': 1}, {'name': 'x', 'value': 1}]},
      {'state': 'C', 'results': [{'name': 'r'}, {'name': 's'}, {'name': 't'}],
       'parameters': [{'name': 'q', 'from': 'par.p'}]}]}})"));
}

TEST(TakenOver, HasTheTextsOfTheLinksThatGiveNoExpression) {
  const Model m = taken_over();
  std::vector<std::string> found;
  for (const TakenOver& taken : taken_over_texts(m.tree(), m["R"])) {
    EXPECT_EQ(taken.link, m["R/A"]);
    found.push_back(taken.text.text);
  }
  EXPECT_EQ(found, (std::vector<std::string>{"chi.C.res.s", "par.p + chi.C.res.r"}));
}

TEST(Rename, RefusesWhatATextOfTheLibraryNamesForALink) {
  Model m = taken_over();
  ASSERT_EQ(m.violations(), "");
  for (const char* named : {"R/p", "R/C", "R/C/r", "R/C/s"})
    EXPECT_EQ(refusal(rename(m.tree(), m[named], "new")), m["R/A"] + ": scope") << named;
  m.apply(rename(m.tree(), m["R/C/t"], "new"));
  m.apply(Edit{{Insert{{m["R"], ListName::variables, {}}, json("{'name': 'u', 'meta': {'id': 'u'}}")}}});
  m.apply(Edit{{Set{m["library/L/w"], "from", {}, Value("par.p + var.free")}}});
  EXPECT_EQ(refusal(rename(m.tree(), "u", "free")), "name: duplicate");
  m.apply(Edit{{Set{m["library/L/w"], "from", {}, Value("(par.p")}}});
  EXPECT_EQ(refusal(rename(m.tree(), m["R/p"], "q")), m["library/L/w"] + ": syntax");
  m.apply(Edit{{Remove{m["R/A"]}, Set{m["R"], "first", {}, {}}}});
  m.apply(rename(m.tree(), m["R/p"], "q"));
}

TEST(Group, RefusesLinksWhoseExpressionsStandInTheLibrary) {
  Model m = taken_over();
  EXPECT_EQ(refusal(group(m.tree(), {m["R/A"]}, "G", "s")), m["R/A"] + ": scope");
  EXPECT_EQ(refusal(group(m.tree(), {m["R/C"]}, "G", "s")), m["R/A"] + ": scope") << "A reads a result of C";
  m.apply(group(m.tree(), {m["R/B"]}, "G", "s"));
  EXPECT_EQ(m.violations(), "");
  m.apply(ungroup(m.tree(), m["R/G"]));
}

TEST(Ungroup, RefusesLinksWhoseExpressionsStandInTheLibrary) {
  Model m(json(R"({'rcm': 1, 'library': [{'state': 'L', 'parameters': [{'name': 'w', 'from': 'par.p'}]},
                                         {'state': 'M', 'parameters': [{'name': 'w', 'from': 'chi.G.res.r'}]},
                                         {'state': 'N', 'parameters': [{'name': 'w', 'from': 'chi.K.res.r'}]}],
    'root': {'state': 'R', 'first': 'G', 'parameters': [{'name': 'q', 'value': 1}], 'children': [
      {'state': 'G', 'first': 'A', 'parameters': [{'name': 'p', 'from': 'par.q'}], 'results': [{'name': 'r'}],
       'actions': [{'when': 'available(chi.K.res.r)', 'do': 'res.r = chi.K.res.r'}],
       'children': [{'state': 'A', 'link': 'L'}, {'state': 'D', 'link': 'N'}, {'state': 'K', 'results': [{'name': 'r'}]}]},
      {'state': 'B', 'link': 'M'}]}})"));
  ASSERT_EQ(m.violations(), "");
  EXPECT_EQ(refusal(ungroup(m.tree(), m["R/G"])), m["R/G/A"] + ": scope");
  m.apply(Edit{{Remove{m["R/G/A"]}, Set{m["R/G"], "first", {}, Value("D")}}});
  EXPECT_EQ(refusal(ungroup(m.tree(), m["R/G"])), m["R/B"] + ": scope");
  m.apply(Edit{{Remove{m["R/B"]}}});
  m.apply(ungroup(m.tree(), m["R/G"]));
  EXPECT_EQ(m.violations(), "") << "K is a sibling of D as before";
}

TEST(RenameService, ChangesItsKeyAndCode) {
  Model m = task();
  m.apply(rename_service(m.tree(), "arm", "left"));
  EXPECT_EQ(m.tree().fields().services, (std::map<std::string, std::string>{{"left", "robot"}}));
  const std::string action = m.tree().list(m["Root"], ListName::actions)[0];
  EXPECT_EQ(std::get<rcm::Action>(m.tree().find(action)->content).code, "svc[\"left\"].stop(chi.T.res.got)");
  EXPECT_EQ(refusal(rename_service(m.tree(), "arm", "x")), "key: not_found");
  EXPECT_EQ(refusal(rename_service(m.tree(), "left", "")), "name: name");
  m.apply(Edit{{Set{m["Root"], "exit", {}, Value("svc.right.stop()")}}});
  EXPECT_EQ(refusal(rename_service(m.tree(), "left", "right")), "name: duplicate") << "an undeclared service";
}

TEST(Connect, LetsPortsAndBarriersLeadToSiblings) {
  Model m = task();
  m.apply(connect(m.tree(), m["Root/A/done"], m["Root/T"]));
  EXPECT_EQ(m.field("Root/A/done", "to"), "\"T\"");
  m.apply(connect(m.tree(), m["Root/A/done"], std::nullopt));
  EXPECT_EQ(m.field("Root/A/done", "to"), "");
  m.apply(disconnect(m.tree(), m["Root/b"], m["Root/A"]));
  EXPECT_EQ(m.field("Root/b", "to"), R"(["T"])");
  m.apply(connect(m.tree(), m["Root/b"], m["Root/A"]));
  m.apply(connect(m.tree(), m["Root/b"], m["Root/A"]));
  EXPECT_EQ(m.field("Root/b", "to"), R"(["T","A"])");
  EXPECT_EQ(refusal(connect(m.tree(), m["Root/A/done"], m["library/Tool"])), "to: port_target");
  EXPECT_EQ(refusal(connect(m.tree(), m["Root/end"], m["Root"])), "to: port_target");
  EXPECT_EQ(refusal(connect(m.tree(), m["Root/b"], m["Root/b"])), "to: barrier_target");
  EXPECT_EQ(refusal(connect(m.tree(), m["Root/A"], m["Root/T"])), "from: not_accepted");
  EXPECT_EQ(refusal(connect(m.tree(), m["Root/A/done"], "nobody")), "to: not_found");
}

TEST(Duplicate, HasAFreeNameNewIdsAndTheSameTargets) {
  Model m = task();
  m.apply(duplicate(m.tree(), m["Root/A"], "seed"));
  EXPECT_EQ(m.violations(), "");
  EXPECT_EQ(m.tree().list(m["Root"], ListName::children)[1], m["Root/A2"]);
  EXPECT_EQ(m.field("Root/A2/done", "to"), "\"b\"");
  m.apply(duplicate(m.tree(), m["Root/A"], "seed"));
  EXPECT_EQ(m.tree().list(m["Root"], ListName::children)[1], m["Root/A3"]) << "the same seed is no harm";
  m.apply(duplicate(m.tree(), m.tree().list(m["Root"], ListName::actions)[0], "seed"));
  m.apply(duplicate(m.tree(), m["library/Tool"], "seed"));
  EXPECT_EQ(refusal(duplicate(m.tree(), m["Root"], "seed")), "id: not_accepted");
}

TEST(Extract, PutsALinkInThePlaceOfTheState) {
  Model m = task();
  const std::string a = m["Root/A"];
  m.apply(extract(m.tree(), a, "Step", "seed"));
  EXPECT_EQ(m.violations(), "");
  EXPECT_EQ(m["library/Step"], a);
  EXPECT_EQ(m.field("Root/A", "link"), "\"Step\"");
  EXPECT_EQ(m.field("Root/A/done", "to"), "\"b\"");
  EXPECT_EQ(m.field("Root/A/a", "from"), "\"par.p + var.v\"");
  EXPECT_EQ(m.field("library/Step/a", "from"), "");
  EXPECT_EQ(refusal(extract(m.tree(), m["Root/A"], "Other", "s")), "id: not_accepted");
  EXPECT_EQ(refusal(extract(m.tree(), m["Root"], "Other", "s")), "id: not_accepted");
  EXPECT_EQ(refusal(extract(m.tree(), m["Root/b"], "Other", "s")), "id: not_accepted");
  m.apply(duplicate(m.tree(), m["Root/b"], "s"));
  EXPECT_EQ(refusal(extract(m.tree(), "nobody", "Other", "s")), "id: not_found");
}

Model chain() {
  return Model(json(R"({'rcm': 1, 'root': {'state': 'R', 'first': 'A', 'parameters': [{'name': 'p', 'value': 1}],
    'actions': [{'when': 'available(chi.C.res.r)', 'do': 'var.x = chi.C.res.r'}],
    'children': [
      {'state': 'A', 'results': [{'name': 'r'}], 'ports': [{'name': 'ok', 'when': 'True', 'to': 'B'}]},
      {'state': 'B', 'parameters': [{'name': 'p', 'from': 'par.p + chi.A.res.r'}],
       'ports': [{'name': 'ok', 'when': 'True', 'to': 'C'}, {'name': 'no', 'when': 'False', 'to': 'D'}]},
      {'state': 'C', 'results': [{'name': 'r', 'type': 'int'}], 'parameters': [{'name': 'q', 'from': 'chi.B.par.p'}],
       'ports': [{'name': 'ok', 'when': 'True', 'to': 'D'}, {'name': 'again', 'when': 'False', 'to': 'B'}]},
      {'state': 'D', 'ports': [{'name': 'end', 'when': 'False', 'to': 'A'}]}]}})"));
}

TEST(Group, HasPortsParametersAndResultsForWhatCrossesItsBorder) {
  Model m = chain();
  ASSERT_EQ(m.violations(), "");
  m.apply(group(m.tree(), {m["R/C"], m["R/B"]}, "G", "seed"));
  EXPECT_EQ(m.violations(), "");
  EXPECT_EQ(m.field("R/G", "first"), "\"B\"");
  EXPECT_EQ(m.field("R/A/ok", "to"), "\"G\"");
  EXPECT_EQ(m.field("R/G/B_no", "when"), "\"chi.B.port.no\"");
  EXPECT_EQ(m.field("R/G/B_no", "to"), "\"D\"");
  EXPECT_EQ(m.field("R/G/B/no", "to"), "");
  EXPECT_EQ(m.field("R/G/C/again", "to"), "\"B\"");
  EXPECT_EQ(m.field("R/G/B/p", "from"), "\"par.p + par.A_r\"");
  EXPECT_EQ(m.field("R/G/A_r", "from"), "\"chi.A.res.r\"");
  EXPECT_EQ(m.field("R/G/C_r", "type"), "\"int\"");
  const Value root = m.tree().write(m["R"]);
  EXPECT_EQ(*root.find("actions")->as_list()[0].find("do"), Value("var.x = chi.G.res.C_r"));
}

TEST(Group, RefusesWhatItCouldNotKeep) {
  Model m = chain();
  const auto refused = [](const Model& of, std::initializer_list<const char*> states) {
    Ids ids;
    for (const char* state : states) ids.push_back(of[state]);
    return refusal(group(of.tree(), ids, "G", "seed"));
  };
  EXPECT_EQ(refused(m, {"R/A", "R/C"}), m["R"] + ": first") << "entered at A and C";
  EXPECT_EQ(refused(m, {}), "ids: not_accepted");
  EXPECT_EQ(refused(m, {"R"}), "ids: not_accepted");
  EXPECT_EQ(refusal(group(m.tree(), {m["R/A"]}, "D", "s")), "name: duplicate");
  m.apply(Edit{{Set{m["R/C/q"], "from", {}, Value("var.x")}}});
  EXPECT_EQ(refused(m, {"R/B", "R/C"}), m["R/C/q"] + ": scope");
  m.apply(Edit{{Set{m["R/C/q"], "from", {}, Value("len(par)")}}});
  EXPECT_EQ(refused(m, {"R/B", "R/C"}), m["R/C/q"] + ": scope");
  m.apply(Edit{{Set{m["R/C/q"], "from", {}, Value("(")}}});
  EXPECT_EQ(refused(m, {"R/B", "R/C"}), m["R/C/q"] + ": syntax");
  m = chain();
  m.apply(Edit{{Set{m["R"], "exit", {}, Value("var.x = chi.B.active")}}});
  EXPECT_EQ(refused(m, {"R/B", "R/C"}), m["R"] + ": scope");
  m = chain();
  m.apply(Edit{{Set{m["R/C"], "keep", {}, Value(true)}}});
  EXPECT_EQ(refused(m, {"R/B", "R/C"}), m["R/C"] + ": keep");
  m = chain();
  m.apply(extract(m.tree(), m["R/B"], "Linked", "s"));
  m.apply(Edit{{Set{m["library/Linked"], "oracle", {}, json("{'kind':'history'}")}}});
  EXPECT_EQ(refused(m, {"R/B", "R/C"}), m["R/B"] + ": keep");
  m = task();
  EXPECT_EQ(refused(m, {"Root/b"}), m["Root"] + ": first");
  m.apply(Edit{{Set{m["Root/A/done"], "to", {}, {}}}});
  EXPECT_EQ(refused(m, {"Root/b"}), m["Root/b"] + ": barrier_target");
}

// A deep history goes on with B; Work is a state of the library that it links.
Model deep_history() {
  return Model(json(R"({'rcm': 1, 'library': [{'state': 'Work', 'first': 'A', 'children': [
      {'state': 'A', 'ports': [{'name': 'a', 'when': 'True', 'to': 'B'}]}, {'state': 'B'}]}],
    'root': {'state': 'R', 'first': 'W', 'children': [{'state': 'W', 'link': 'Work'}],
      'ports': [{'name': 'hit', 'when': 'False'}], 'oracle': {'kind': 'history', 'resume': ['hit'], 'deep': true}}})"));
}

TEST(Group, RefusesChildrenOfAStateThatADeepHistoryResumes) {
  Model m = deep_history();
  const Ids pair{m["library/Work/A"], m["library/Work/B"]};
  EXPECT_EQ(refusal(group(m.tree(), pair, "G", "s")), m["library/Work"] + ": keep");
  m.apply(Edit{{Set{m["library/Work"], "keep", {}, Value(List{})}}});
  m.apply(group(m.tree(), pair, "G", "s"));
  m.apply(Edit{{Set{m["library/Work"], "keep", {}, {}}}});
  EXPECT_EQ(refusal(ungroup(m.tree(), m["library/Work/G"])), m["library/Work/G"] + ": not_accepted");
}

TEST(Group, RefusesChildrenOfAStateThatKeepsDeep) {
  Model m = deep_history();
  m.apply(Edit{{Set{m["library/Work"], "keep", {}, json("{'deep': true, 'ports': []}")}}});
  EXPECT_EQ(refusal(group(m.tree(), {m["library/Work/B"]}, "G", "s")), m["library/Work"] + ": keep");
}

TEST(Group, OffersThePortsThatTheParentReads) {
  Model m = chain();
  m.apply(Edit{{Set{m["R/C/ok"], "to", {}, {}}}});
  m.apply(Edit{{Set{m["R"], "entry", {}, Value("var.x = chi.C.port.ok or chi.B.port.no")}}});
  const std::string before = m.text();
  EXPECT_EQ(refusal(group(m.tree(), {m["R/B"], m["R/C"], m["R/D"]}, "G", "s")), m["R"] + ": scope")
      << "chi.B.port.no leads to D";
  m.apply(group(m.tree(), {m["R/B"], m["R/C"]}, "G", "s"));
  EXPECT_EQ(m.violations(), "");
  EXPECT_EQ(m.field("R", "entry"), "\"var.x = chi.G.port.C_ok or chi.G.port.B_no\"");
  EXPECT_EQ(m.field("R/G/C_ok", "to"), "");
  m.apply(ungroup(m.tree(), m["R/G"]));
  EXPECT_EQ(m.text(), before);
}

TEST(Ungroup, IsTheWayBack) {
  Model m = chain();
  const std::string before = m.text();
  m.apply(group(m.tree(), {m["R/B"], m["R/C"]}, "G", "seed"));
  m.apply(ungroup(m.tree(), m["R/G"]));
  EXPECT_EQ(m.text(), before);
}

TEST(Ungroup, PutsValuesInPlaceOfParameters) {
  Model m(
      json(R"({'rcm': 1, 'root': {'state': 'R', 'first': 'G', 'parameters': [{'name': 'x', 'value': 1}], 'children': [
    {'state': 'G', 'first': 'A', 'ports': [{'name': 'again', 'when': 'chi.A.port.ok', 'to': 'G'}],
     'parameters': [{'name': 'p', 'value': -1}, {'name': 'q', 'from': 'par.x + 1'}, {'name': 'u', 'value': ['t']}],
     'children': [{'state': 'A', 'parameters': [{'name': 'a', 'from': 'par.p * par.q + len(par.u)'}],
                   'ports': [{'name': 'ok', 'when': 'True'}]}]}]}})"));
  m.apply(ungroup(m.tree(), m["R/G"]));
  EXPECT_EQ(m.violations(), "");
  EXPECT_EQ(m.field("R/A/a", "from"), "\"(-1) * (par.x + 1) + len(['t'])\"");
  EXPECT_EQ(m.field("R", "first"), "\"A\"");
  EXPECT_EQ(m.field("R/A/ok", "to"), "\"A\"");
}

TEST(Ungroup, RefusesStatesThatDoSomethingThemselves) {
  const auto refused = [](const std::string& field, const std::string& value) {
    Model m = chain();
    m.apply(group(m.tree(), {m["R/B"], m["R/C"]}, "G", "seed"));
    m.apply(Edit{{Set{m["R/G"], field, {}, json(value)}}});
    return refusal(ungroup(m.tree(), m["R/G"])) == m["R/G"] + ": not_accepted";
  };
  EXPECT_TRUE(refused("entry", "'pass'"));
  EXPECT_TRUE(refused("keep", "['B_no']"));
  EXPECT_TRUE(refused("keep", "{'deep':true}"));
  EXPECT_TRUE(refused("oracle", "{'kind':'history'}"));
  EXPECT_TRUE(refused("first", "'Nobody'"));
  Model m = chain();
  m.apply(group(m.tree(), {m["R/B"], m["R/C"]}, "G", "seed"));
  const auto with = [&](const std::string& id, const std::string& field, const std::string& value) {
    Model changed = m;
    changed.apply(Edit{{Set{id, field, {}, Value(value)}}});
    return refusal(ungroup(changed.tree(), changed["R/G"]));
  };
  EXPECT_EQ(with(m["R/G/B_no"], "when", "chi.B.port.no and True"), m["R/G/B_no"] + ": not_accepted");
  EXPECT_EQ(with(m["R/A"], "state", "B"), m["R/G/B"] + ": duplicate");
  EXPECT_EQ(with(m["R/G/C/q"], "from", "var.z"), m["R/G/C/q"] + ": not_accepted");
  EXPECT_EQ(with(m["R"], "entry", "var.x = chi.G.active"), m["R"] + ": not_accepted");
  EXPECT_EQ(refusal(ungroup(m.tree(), m["R"])), "id: not_accepted");
}

rcm::Document demo(const char* file) {
  return rcm::read_document_text(rcm::read_text(std::string(RACE_SOURCE_DIR "/deploy/demo/") + file)).value();
}

/// Some 40 elements, from all parts.
Ids some_of(const Tree& tree) {
  Ids all, out;
  tree.for_each([&](const Element& element) { all.push_back(meta_of(element.content).id); });
  for (std::size_t i = 0; i < all.size(); i += 1 + all.size() / 40) out.push_back(all[i]);
  return out;
}

Ids states_of(const Tree& tree) {
  Ids out;
  tree.for_each([&](const Element& element) {
    if (std::holds_alternative<rcm::State>(element.content)) out.push_back(meta_of(element.content).id);
  });
  return out;
}

class Demo : public testing::TestWithParam<const char*> {};

TEST_P(Demo, EveryNameCanBeAnotherOneAndBack) {
  const Model first(demo(GetParam()));
  const std::string before = first.text();
  std::size_t renamed = 0;
  for (const std::string& id : some_of(first.tree())) {
    const std::string name = name_of(first.tree().find(id)->content);
    Model m = first;
    const auto edit = rename(m.tree(), id, "Renamed");
    if (!edit) {
      EXPECT_TRUE(edit.error().code == ErrorCode::not_accepted || edit.error().code == ErrorCode::link_port ||
                  edit.error().code == ErrorCode::link_parameter)
          << to_string(edit.error());
      continue;
    }
    SCOPED_TRACE(name);
    m.apply(edit);
    if (++renamed % 7 == 0) {
      ASSERT_EQ(m.violations(), "");
    }
    m.apply(rename(m.tree(), id, name));
    ASSERT_EQ(m.text(), before);
  }
  EXPECT_GT(renamed, 20U);
}

TEST_P(Demo, EveryStateCanGoToTheLibrary) {
  const Model first(demo(GetParam()));
  std::size_t extracted = 0;
  for (const std::string& id : states_of(first.tree())) {
    Model m = first;
    const auto edit = extract(m.tree(), id, "Extracted", "seed");
    if (!edit) continue;
    SCOPED_TRACE(name_of(first.tree().find(id)->content));
    m.apply(edit);
    if (++extracted % 5 == 0) {
      ASSERT_EQ(m.violations(), "");
    }
  }
  EXPECT_GT(extracted, 4U);
}

TEST_P(Demo, NeighboursCanBeGroupedAndUngrouped) {
  const Model first(demo(GetParam()));
  const std::string before = first.text();
  std::size_t grouped = 0;
  for (const std::string& id : states_of(first.tree())) {
    const Ids& children = first.tree().list(id, ListName::children);
    for (std::size_t i = 0; i + 1 < children.size(); ++i) {
      Model m = first;
      const auto edit = group(m.tree(), {children[i], children[i + 1]}, "Grouped", "seed");
      if (!edit) continue;
      SCOPED_TRACE(name_of(first.tree().find(children[i])->content));
      m.apply(edit);
      if (++grouped % 3 == 0) {
        ASSERT_EQ(m.violations(), "");
      }
      m.apply(ungroup(m.tree(), m.tree().find(children[i])->parent));
      ASSERT_EQ(m.text(), before);
    }
  }
  EXPECT_GT(grouped, 2U);
}

INSTANTIATE_TEST_SUITE_P(Documents, Demo, testing::Values("pick.rcm.json", "demonstrator.rcm.json"));

}  // namespace
}  // namespace race::edit
