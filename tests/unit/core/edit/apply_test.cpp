// What one edit does to a document, and what is refused.
#include "core/edit/apply.h"

#include "tests/unit/core/edit/documents.h"

namespace race::edit {
namespace {

/// A tree on which edits are tried.
struct Subject {
  Tree tree = Tree::read(small_document()).value();
  std::string first = text_of(tree);

  /// Applies it, takes it back and applies it again: the document is what it was.
  void apply(const std::string& operations) {
    const std::string before = text_of(tree);
    const Edit edit = edit_of(operations);
    const auto inverse = edit::apply(tree, edit);
    ASSERT_TRUE(inverse) << to_string(inverse.error());
    const std::string after = text_of(tree);
    const auto again = edit::apply(tree, *inverse);
    ASSERT_TRUE(again) << to_string(again.error());
    EXPECT_EQ(text_of(tree), before);
    ASSERT_TRUE(edit::apply(tree, *again));
    EXPECT_EQ(text_of(tree), after);
    const rcm::Document document = tree.document();
    EXPECT_EQ(text_of(Tree::read(document).value()), after) << "the tree is that of its document";
  }

  /// The error, as `path: code`; the document is as before.
  std::string refusal(const std::string& operations) {
    const std::string before = text_of(tree);
    const std::size_t size = tree.size();
    const auto inverse = edit::apply(tree, edit_of(operations));
    EXPECT_EQ(text_of(tree), before);
    EXPECT_EQ(tree.size(), size);
    return inverse ? "accepted" : inverse.error().path + ": " + std::string(name(inverse.error().code));
  }

  std::string children(const std::string& parent) const { return children_of(tree, parent); }
};

TEST(Insert, PutsAnElementBehindItsSiblingOrInFront) {
  Subject s;
  s.apply("[{'op':'insert','parent':'r','list':'children','after':'a','node':{'state':'N','meta':{'id':'n'}}}]");
  EXPECT_EQ(s.children("r"), "a n b c");
  s.apply("[{'op':'insert','parent':'r','list':'children','node':{'barrier':'M','to':[],'meta':{'id':'m'}}}]");
  EXPECT_EQ(s.children("r"), "m a n b c");
}

TEST(Insert, TakesAllBelowTheElement) {
  Subject s;
  s.apply(R"([{'op':'insert','parent':'','list':'library','after':'l','node':
    {'state':'N','children':[{'state':'O','variables':[{'name':'w','meta':{'id':'w'}}],'meta':{'id':'o'}}],
     'meta':{'id':'n'}}}, {'op':'set','id':'w','field':'initial','value':[1,2.0]}])");
  EXPECT_EQ(s.tree.document().library.at(1).children.size(), 1U);
}

TEST(Insert, RefusesWhatIsNoElementOfTheList) {
  Subject s;
  const auto refusal = [&](const std::string& where, const std::string& node) {
    return s.refusal("[{'op':'insert'," + where + ",'node':" + node + "}]");
  };
  const std::string id = "'meta':{'id':'n'}";
  EXPECT_EQ(refusal("'parent':'r','list':'ports'", "{'state':'N'," + id + "}"), "operations/0/node: missing");
  EXPECT_EQ(refusal("'parent':'','list':'library'", "{'barrier':'N','to':[]," + id + "}"), "operations/0/node: type");
  EXPECT_EQ(refusal("'parent':'r','list':'library'", "{'state':'N'," + id + "}"), "operations/0/list: type");
  EXPECT_EQ(refusal("'parent':'','list':'children'", "{'state':'N'," + id + "}"), "operations/0/list: type");
  EXPECT_EQ(refusal("'parent':'c','list':'children'", "{'state':'N'," + id + "}"), "operations/0/parent: type");
  EXPECT_EQ(refusal("'parent':'no','list':'children'", "{'state':'N'," + id + "}"), "operations/0/parent: not_found");
  EXPECT_EQ(refusal("'parent':'r','list':'children','after':'x'", "{'state':'N'," + id + "}"),
            "operations/0/after: not_found");
  EXPECT_EQ(refusal("'parent':'r','list':'children'", "1"), "operations/0/node: type");
  EXPECT_EQ(refusal("'parent':'r','list':'children'", "{'state':'N','more':1," + id + "}"),
            "operations/0/node: unknown_field");
}

TEST(Insert, RefusesElementsWithoutIdsOrWithThoseOfOthers) {
  Subject s;
  const auto refusal = [&](const std::string& node) {
    return s.refusal("[{'op':'insert','parent':'r','list':'children','node':" + node + "}]");
  };
  EXPECT_EQ(refusal("{'state':'N'}"), "operations/0/node: missing");
  EXPECT_EQ(refusal("{'state':'N','meta':{'id':'n'},'ports':[{'name':'p','when':'True'}]}"),
            "operations/0/node: missing");
  EXPECT_EQ(refusal("{'state':'N','meta':{'id':'x'}}"), "operations/0/node: duplicate");
  EXPECT_EQ(refusal("{'state':'N','meta':{'id':'n'},'children':[{'state':'O','meta':{'id':'n'}}]}"),
            "operations/0/node: duplicate");
}

TEST(Remove, TakesAllBelowTheElementAway) {
  Subject s;
  s.apply("[{'op':'remove','id':'b'}]");
  EXPECT_EQ(s.children("r"), "a c");
  EXPECT_EQ(s.tree.find("x"), nullptr);
  s.apply("[{'op':'remove','id':'l'}, {'op':'remove','id':'act'}, {'op':'remove','id':'p'}]");
  EXPECT_TRUE(s.tree.document().library.empty());
}

TEST(Remove, RefusesTheRootAndWhatIsNotThere) {
  Subject s;
  EXPECT_EQ(s.refusal("[{'op':'remove','id':'r'}]"), "operations/0/id: not_accepted");
  EXPECT_EQ(s.refusal("[{'op':'remove','id':'b'}, {'op':'remove','id':'x'}]"), "operations/1/id: not_found");
}

TEST(Move, ChangesTheOrderAndTheParent) {
  Subject s;
  s.apply("[{'op':'move','id':'a','parent':'r','list':'children','after':'c'}]");
  EXPECT_EQ(s.children("r"), "b c a");
  s.apply("[{'op':'move','id':'a','parent':'b','list':'children','after':'x'}]");
  EXPECT_EQ(s.children("b"), "x a y");
  s.apply("[{'op':'move','id':'b','parent':'','list':'library'}]");
  EXPECT_EQ(s.tree.document().library.front().name, "B");
  s.apply("[{'op':'move','id':'adone','parent':'x','list':'ports'}]");
}

TEST(Move, RefusesCyclesTheRootAndOtherLists) {
  Subject s;
  EXPECT_EQ(s.refusal("[{'op':'move','id':'b','parent':'x','list':'children'}]"), "operations/0/parent: not_accepted");
  EXPECT_EQ(s.refusal("[{'op':'move','id':'b','parent':'b','list':'children'}]"), "operations/0/parent: not_accepted");
  EXPECT_EQ(s.refusal("[{'op':'move','id':'r','parent':'l','list':'children'}]"), "operations/0/id: not_accepted");
  EXPECT_EQ(s.refusal("[{'op':'move','id':'c','parent':'','list':'library'}]"), "operations/0/list: type");
  EXPECT_EQ(s.refusal("[{'op':'move','id':'v','parent':'r','list':'results'}]"), "operations/0/list: type");
  EXPECT_EQ(s.refusal("[{'op':'move','id':'a','parent':'r','list':'children','after':'a'}]"),
            "operations/0/after: not_found");
}

TEST(Set, GivesAndTakesFieldsOfEveryKind) {
  Subject s;
  s.apply("[{'op':'set','id':'a','field':'state','value':'Begin'}]");
  s.apply("[{'op':'set','id':'adone','field':'to'}]");
  s.apply("[{'op':'set','id':'c','field':'to','value':['A','B']}]");
  s.apply("[{'op':'set','id':'p','field':'value'},{'op':'set','id':'p','field':'from','value':'1 + 1'}]");
  s.apply("[{'op':'set','id':'p','field':'value','value':null}]");
  s.apply("[{'op':'set','id':'act','field':'do','value':'pass'}]");
  s.apply("[{'op':'set','id':'b','field':'oracle','value':{'kind':'history','resume':['done']}}]");
  s.apply("[{'op':'set','id':'b','field':'keep','value':true}, {'op':'set','id':'b','field':'keep','value':[]}]");
  s.apply("[{'op':'set','id':'a','field':'doc','value':''}]");
}

TEST(Set, GivesAndTakesEntries) {
  Subject s;
  s.apply("[{'op':'set','id':'a','field':'meta','key':'category','value':{'z':1,'a':2}}]");
  s.apply("[{'op':'set','id':'a','field':'meta','key':'title'}]");
  s.apply("[{'op':'set','id':'a','field':'meta','key':'category'}]");
  s.apply("[{'op':'set','id':'','field':'layout','key':'a'}]");
  s.apply("[{'op':'set','id':'','field':'services','key':'t','value':'timer'}]");
  s.apply("[{'op':'set','id':'','field':'notes','key':'a','value':'Why?'}]");
  s.apply(
      "[{'op':'set','id':'','field':'meta','key':'title','value':'T'},{'op':'set','id':'','field':'name','value':'n'}"
      "]");
  s.apply("[{'op':'set','id':'','field':'notes','key':'a'}]");
  EXPECT_EQ(to_json(s.tree.document().meta), R"({"title":"T"})");
}

TEST(Set, RefusesWhatCannotBeRead) {
  Subject s;
  const auto refusal = [&](const std::string& set) { return s.refusal("[{'op':'set'," + set + "}]"); };
  EXPECT_EQ(refusal("'id':'a','field':'state'"), "operations/0/value: missing");
  EXPECT_EQ(refusal("'id':'a','field':'state','value':1"), "operations/0/value: type");
  EXPECT_EQ(refusal("'id':'a','field':'children','value':[]"), "operations/0/field: unknown_field");
  EXPECT_EQ(refusal("'id':'a','field':'barrier','value':'x'"), "operations/0/field: unknown_field");
  EXPECT_EQ(refusal("'id':'act','field':'name','value':'x'"), "operations/0/field: unknown_field");
  EXPECT_EQ(refusal("'id':'a','field':'doc','key':'x','value':'x'"), "operations/0/key: unknown_field");
  EXPECT_EQ(refusal("'id':'a','field':'oracle','value':{'kind':'chance'}"), "operations/0/value: oracle");
  EXPECT_EQ(refusal("'id':'a','field':'meta','key':'id','value':'z'"), "operations/0/key: not_accepted");
  EXPECT_EQ(refusal("'id':'a','field':'meta','value':{}"), "operations/0/key: missing");
  EXPECT_EQ(refusal("'id':'no','field':'doc','value':''"), "operations/0/id: not_found");
  EXPECT_EQ(refusal("'id':'','field':'root','value':{}"), "operations/0/field: unknown_field");
  EXPECT_EQ(refusal("'id':'','field':'name','value':1"), "operations/0/value: type");
  EXPECT_EQ(refusal("'id':'','field':'services','key':'t','value':1"), "operations/0/value: type");
  EXPECT_EQ(refusal("'id':'','field':'layout','value':1"), "operations/0/key: missing");
  EXPECT_EQ(refusal("'id':'','field':'meta','key':'notes','value':{}"), "operations/0/key: not_accepted");
}

TEST(Set, KeepsADraftWithViolations) {
  Subject s;
  s.apply("[{'op':'set','id':'a','field':'state','value':'no name'}]");
  s.apply("[{'op':'set','id':'a','field':'state','value':'B'}]");
  s.apply("[{'op':'set','id':'adone','field':'when','value':'('}]");
}

TEST(Apply, IsAllOrNothing) {
  Subject s;
  EXPECT_EQ(s.refusal("[{'op':'set','id':'a','field':'doc','value':'x'}, {'op':'remove','id':'x'},"
                      " {'op':'move','id':'y','parent':'r','list':'children'}, {'op':'remove','id':'x'}]"),
            "operations/3/id: not_found");
  EXPECT_EQ(text_of(s.tree), s.first);
}

TEST(Apply, NeedsADocumentWithIds) {
  rcm::Document document = small_document();
  document.root.ports.push_back(rcm::Port{"p", "True", std::nullopt, std::nullopt, {}});
  EXPECT_EQ(apply(document, Edit{}).error().code, ErrorCode::missing);
  document.root.ports.back().meta.id = "a";
  EXPECT_EQ(apply(document, Edit{}).error().code, ErrorCode::duplicate);
  document.root.ports.back().meta.id = "port";
  EXPECT_EQ(apply(document, Edit{}).value().document, document);
}

/// A state with `levels` levels of states below it.
Value nested(int levels, const std::string& prefix) {
  Dict out{{"state", "N"}, {"meta", Dict{{"id", prefix + std::to_string(levels)}}}};
  if (levels > 0) out.set("children", List{nested(levels - 1, prefix)});
  return out;
}

TEST(Apply, RefusesDocumentsThatCouldNotBeReadAgain) {
  const auto inserted = [](int levels) { return Edit{{Insert{{"r", ListName::children, {}}, nested(levels, "n")}}}; };
  int deepest = 0;
  for (; apply(small_document(), inserted(deepest)); ++deepest) {
    const auto text = rcm::write_document_text(apply(small_document(), inserted(deepest))->document);
    ASSERT_TRUE(text);
  }
  EXPECT_EQ(apply(small_document(), inserted(deepest)).error().code, ErrorCode::too_deep);
  Tree tree = Tree::read(small_document()).value();
  ASSERT_TRUE(apply(tree, inserted(deepest - 1)));
  const std::string leaf = "n0";
  EXPECT_FALSE(apply(tree, Edit{{Move{"b", {leaf, ListName::children, {}}}}})) << "B has children";
  EXPECT_FALSE(apply(tree, Edit{{Set{leaf, "meta", "title", json("[[[[[1]]]]]")}}}));
  EXPECT_TRUE(rcm::write_document_text(tree.document()));
}

TEST(Apply, RefusesDocumentsWithTooMuchText) {
  Tree tree = Tree::read(small_document()).value();
  const std::string before = text_of(tree);
  const auto doc = [](std::size_t bytes) { return Edit{{Set{"a", "doc", {}, Value(std::string(bytes, 'x'))}}}; };
  const std::size_t most = JsonLimits{}.bytes - before.size() - std::string("        \"doc\": \"\",\n").size();
  EXPECT_EQ(apply(tree, doc(most + 1)).error().code, ErrorCode::too_large);
  EXPECT_TRUE(text_of(tree) == before);
  EXPECT_TRUE(apply(tree, doc(most)));
}

TEST(Apply, MeasuresTextOnOneLineByTheLimitsOfItsReader) {
  const auto doc = [](std::size_t bytes) { return Edit{{Set{"a", "doc", {}, Value(std::string(bytes, 'x'))}}}; };
  const std::size_t bytes = to_json(rcm::write_document(apply(small_document(), doc(9))->document)).size();
  Tree small = Tree::read(small_document(), JsonLimits{.bytes = bytes}).value();
  const std::string before = text_of(small);
  EXPECT_EQ(apply(small, doc(10)).error().code, ErrorCode::too_large);
  EXPECT_EQ(text_of(small), before);
  EXPECT_TRUE(apply(small, doc(9)));
  // A state with n levels below it, in the root: its innermost `meta` is at level 5 + 2 n.
  const auto inserted = [](int levels) { return Edit{{Insert{{"r", ListName::children, {}}, nested(levels, "n")}}}; };
  Tree deep = Tree::read(small_document(), JsonLimits{.depth = 99}).value();
  EXPECT_EQ(apply(deep, inserted(48)).error().code, ErrorCode::too_deep);
  EXPECT_TRUE(apply(deep, inserted(47)));
}

}  // namespace
}  // namespace race::edit
