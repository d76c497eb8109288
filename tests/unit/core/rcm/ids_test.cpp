// Ids: who gets which, and that the same documents always get the same.
#include "core/rcm/ids.h"

#include <gtest/gtest.h>

#include <random>

#include "core/rcm/document.h"
#include "tests/unit/core/rcm/cases.h"

namespace race::rcm {
namespace {

Document draft_of(std::string_view text) {
  const Draft draft = read_draft(parse_json(text).value());
  EXPECT_TRUE(draft.errors.empty()) << to_string(draft.errors.front());
  return draft.document;
}

Document rooted(std::string_view root) { return draft_of(R"({"rcm": 1, "root": )" + std::string(root) + "}"); }

Document with_ids(Document document, const Document* previous = nullptr) {
  give_ids(document, previous);
  return document;
}

State& child(State& state, std::size_t number) { return std::get<State>(state.children[number]); }
const State& child(const State& state, std::size_t number) { return std::get<State>(state.children[number]); }

/// The metas of all elements below `json`, a document.
void collect_metas(const Value& json, std::vector<const Value*>& out) {
  if (json.is_list()) {
    for (const Value& item : json.as_list()) collect_metas(item, out);
  } else if (json.is_dict()) {
    for (const auto& [key, value] : json.as_dict())
      key.as_string() == "meta" ? out.push_back(&value) : collect_metas(value, out);
  }
}

std::vector<std::string> ids_in(const Document& document) {
  const Value json = write_document(document);
  std::vector<const Value*> metas;
  collect_metas(json, metas);
  std::vector<std::string> out;
  for (const Value* meta : metas) out.push_back(meta->find("id")->as_string());
  return out;
}

constexpr const char* kAllKinds = R"json({"rcm": 1,
  "library": [{"state": "L", "parameters": [{"name": "p"}], "ports": [{"name": "q", "when": "True"}]}],
  "root": {"state": "R", "parameters": [{"name": "p", "value": 1}], "results": [{"name": "p"}],
    "variables": [{"name": "p"}], "actions": [{"when": "True", "do": "pass"}, {"when": "True", "do": "pass"}],
    "children": [{"barrier": "b", "to": ["A"]},
                 {"state": "A", "link": "L", "parameters": [{"name": "p", "value": 1}], "ports": [{"name": "q", "to": "b"}]}],
    "ports": [{"name": "p", "when": "True"}]}})json";

TEST(GiveIds, GivesEveryElementItsOwn) {
  const std::vector<std::string> ids = ids_in(with_ids(draft_of(kAllKinds)));
  EXPECT_EQ(ids.size(), 14U);
  for (const std::string& id : ids) {
    EXPECT_EQ(id.size(), 8U);
    EXPECT_TRUE(std::ranges::all_of(id, [](char c) { return std::islower(c) || std::isdigit(c); })) << id;
  }
  EXPECT_EQ(std::set<std::string>(ids.begin(), ids.end()).size(), ids.size());
}

TEST(GiveIds, GivesTheSameDocumentTheSameIds) {
  const Document document = with_ids(draft_of(kAllKinds));
  EXPECT_EQ(with_ids(draft_of(kAllKinds)), document);
  EXPECT_EQ(with_ids(document), document) << "who has one keeps it";
}

TEST(GiveIds, DoesNotDependOnWhatElseIsThere) {
  const Document one = with_ids(rooted(R"({"state": "R", "children": [{"state": "A"}, {"state": "N"}]})"));
  const Document other = with_ids(rooted(R"({"state": "R", "children": [{"state": "N"}], "actions": []})"));
  EXPECT_EQ(child(one.root, 1).meta, child(other.root, 0).meta);
}

TEST(GiveIds, LeavesTheOtherEntriesOfMeta) {
  const Document document = with_ids(rooted(R"({"state": "R", "meta": {"icon": "hand"}, "ports": [
      {"name": "p", "when": "True", "meta": [7]}, {"name": "q", "when": "True", "meta": {}}]})"));
  EXPECT_EQ(document.root.meta.rest, Value(Dict{{"icon", "hand"}}));
  EXPECT_EQ(document.root.ports[0].meta.rest, Value(Dict{{"value", List{7}}})) << "what is no object becomes an entry";
  EXPECT_EQ(document.root.ports[1].meta.rest, Value());
  EXPECT_EQ(read_document(write_document(document)).value(), document);
}

TEST(GiveIds, LetsTheFirstOfACopiedBlockKeepItsIds) {
  Document document = with_ids(rooted(R"({"state": "R", "children": [
      {"state": "A", "ports": [{"name": "p", "when": "True"}]}]})"));
  const State original = child(document.root, 0);
  State copy = original;
  copy.name = "B";
  document.root.children.insert(document.root.children.begin(), copy);
  give_ids(document);
  EXPECT_EQ(child(document.root, 0).meta, original.meta) << "without a previous document, the first one";
  EXPECT_NE(child(document.root, 1).meta, original.meta);
  EXPECT_NE(child(document.root, 1).ports[0].meta, original.ports[0].meta);
}

TEST(GiveIds, LetsTheOriginalOfACopiedBlockKeepItsIds) {
  const Document previous = with_ids(rooted(R"({"state": "R", "children": [
      {"state": "A", "ports": [{"name": "p", "when": "True"}]}]})"));
  Document document = previous;
  State copy = child(document.root, 0);
  copy.name = "B";
  document.root.children.insert(document.root.children.begin(), copy);
  give_ids(document, &previous);
  EXPECT_EQ(child(document.root, 1), child(previous.root, 0)) << "it stands where it stood";
  EXPECT_NE(child(document.root, 0).meta, copy.meta);
  EXPECT_NE(child(document.root, 0).ports[0].meta, copy.ports[0].meta);
}

TEST(GiveIds, LetsWhatStaysInItsStateKeepItsIdIfTheOriginalWasEditedToo) {
  const Document previous = rooted(R"({"state": "R", "children": [{"state": "A", "meta": {"id": "a"},
      "actions": [{"when": "True", "do": "pass", "meta": {"id": "x"}}],
      "children": [{"state": "C", "meta": {"id": "c"}}]}]})");
  Document document = previous;
  State& original = child(document.root, 0);
  original.actions[0].when = "False";
  child(original, 0).name = "D";
  State copy = original;
  copy.name = "B";
  document.root.children.insert(document.root.children.begin(), copy);
  give_ids(document, &previous);
  EXPECT_EQ(child(document.root, 1).actions[0].meta.id, "x");
  EXPECT_EQ(child(child(document.root, 1), 0).meta.id, "c") << "of a node, the parent stays";
  EXPECT_NE(child(document.root, 0).actions[0].meta.id, "x");
  EXPECT_NE(child(child(document.root, 0), 0).meta.id, "c");
}

TEST(GiveIds, PrefersWhatStandsWhereItStoodToWhatStaysInItsState) {
  const Document previous = rooted(R"({"state": "R", "children": [{"state": "A", "meta": {"id": "a"}}]})");
  Document document = previous;
  document.root.children.insert(document.root.children.begin(), child(document.root, 0));
  child(document.root, 0).name = "B";
  give_ids(document, &previous);
  EXPECT_EQ(child(document.root, 1).meta.id, "a");
}

TEST(GiveIds, PrefersTheRootToTheLibrary) {
  Document document = rooted(R"({"state": "R", "meta": {"id": "a"}})");
  document.library = {State{document.root}};
  give_ids(document);
  EXPECT_EQ(document.root.meta.id, "a");
  EXPECT_NE(document.library[0].meta.id, "a");
}

TEST(GiveIds, RestoresLostIdsFromThePreviousDocument) {
  Document previous = with_ids(draft_of(kAllKinds));
  previous.root.actions[0].meta.id = "first";
  previous.root.actions[1].meta.id = "second";
  previous.root.ports[0].meta.id = "port";
  EXPECT_EQ(with_ids(draft_of(kAllKinds), &previous), previous);
}

TEST(GiveIds, TakesNoIdOfThePreviousDocumentThatAnotherElementHas) {
  const Document previous = with_ids(rooted(R"({"state": "R", "children": [{"state": "A"}]})"));
  Document document = previous;
  child(document.root, 0).name = "B";
  document.root.children.emplace_back(State{});
  child(document.root, 1).name = "A";
  give_ids(document, &previous);
  EXPECT_EQ(child(document.root, 0).meta, child(previous.root, 0).meta) << "a renamed state keeps its id";
  EXPECT_NE(child(document.root, 1).meta, child(previous.root, 0).meta);
}

TEST(GiveIds, MakesNoIdAnewThatAnElementJustLeft) {
  const Document first = with_ids(rooted(R"({"state": "R", "children": [{"state": "A"}]})"));
  Document renamed = first;
  child(renamed.root, 0).name = "B";
  const Document last = with_ids(rooted(R"({"state": "R", "children": [{"state": "A"}]})"), &renamed);
  EXPECT_NE(child(last.root, 0).meta, child(first.root, 0).meta) << "B was removed, A is new";
}

TEST(GiveIds, MakesNoIdThatTheLayoutOrANoteNames) {
  const Document first = with_ids(rooted(R"({"state": "R", "children": [{"state": "A"}]})"));
  const std::string id = child(first.root, 0).meta.id;
  for (const std::string& entries :
       {R"("layout": {")" + id + R"(": {"x": 1}})", R"("meta": {"notes": {")" + id + R"(": "n"}})"}) {
    const Document other =
        with_ids(draft_of(R"({"rcm": 1, "root": {"state": "R", "children": [{"state": "A"}]}, )" + entries + "}"));
    EXPECT_NE(child(other.root, 0).meta.id, id) << "it names an element that is gone: " << entries;
    EXPECT_EQ(other.root.meta, first.root.meta);
  }
}

TEST(GiveIds, TellsTheLibraryFromARootOfThisName) {
  const auto document = [](const std::string& meta) {
    return draft_of(R"({"rcm": 1, "library": [{"state": "L")" + meta + R"(}],
      "root": {"state": "library", "children": [{"state": "L"}]}, "layout": {"library/L": 1}})");
  };
  const Document previous = with_ids(document(R"(, "meta": {"id": "l"})"));
  EXPECT_NE(child(previous.root, 0).meta.id, "l");
  EXPECT_EQ(with_ids(document(""), &previous), previous);
  Document without_child = previous;
  without_child.root.children.clear();
  EXPECT_EQ(with_ids(document(""), &without_child).library[0].meta.id, "l");
  EXPECT_EQ(previous.layout, Value(Dict{{child(previous.root, 0).meta.id, 1}}));
}

TEST(GiveIds, TellsAnActionFromAnElementOfAStateOfThisName) {
  const Document previous = draft_of(R"({"rcm": 1, "root": {"state": "R", "children": [{"state": "action",
      "ports": [{"name": "p", "when": "True", "meta": {"id": "p"}}]}]}})");
  const Document document =
      with_ids(draft_of(R"({"rcm": 1, "root": {"state": "R", "actions": [{"when": "port", "do": "p"}]}})"), &previous);
  EXPECT_NE(document.root.actions[0].meta.id, "p");
}

TEST(GiveIds, FollowsAnActionByItsTextAndNumberAmongEquals) {
  Document previous = rooted(R"({"state": "R", "actions": [
      {"when": "True", "do": "pass", "meta": {"id": "x"}}, {"when": "False", "do": "pass", "meta": {"id": "y"}},
      {"when": "True", "do": "pass", "meta": {"id": "z"}}]})");
  Document document = with_ids(rooted(R"({"state": "R", "actions": [
      {"when": "False", "do": "pass"}, {"when": "True", "do": "pass"}, {"when": "True", "do": "pass"}]})"),
                               &previous);
  EXPECT_EQ(document.root.actions[0].meta.id, "y");
  EXPECT_EQ(document.root.actions[1].meta.id, "x");
  EXPECT_EQ(document.root.actions[2].meta.id, "z");
}

TEST(GiveIds, ReplacesThePathsOfTheLayout) {
  Document document = draft_of(R"json({"rcm": 1, "library": [{"state": "L", "meta": {"id": "l"}}],
    "root": {"state": "R", "meta": {"id": "r"}, "children": [
      {"state": "A", "meta": {"id": "a"}, "ports": [{"name": "p", "when": "True", "meta": {"id": "p"}}]},
      {"barrier": "b", "to": [], "meta": {"id": "b"}}]},
    "layout": {"a": 0, "R": 1, "R/A": 2, "R/A.p": 3, "R/b": 4, "library/L": 5, "p": 6, "R/Nobody": 7, "x y": 8, "": 9}})json");
  give_ids(document);
  EXPECT_EQ(document.layout,
            Value(Dict{{"a", 0}, {"r", 1}, {"p", 6}, {"b", 4}, {"l", 5}, {"R/Nobody", 7}, {"x y", 8}, {"", 9}}))
      << to_json(document.layout) << ": an entry by id, before or after it, is newer than one by path";
}

TEST(GiveIds, LeavesTheLayoutAsARenameLeavesIt) {
  Document document = with_ids(
      draft_of(R"({"rcm": 1, "root": {"state": "R", "children": [{"state": "A"}]}, "layout": {"R/A": {"x": 1}}})"));
  const Value layout = document.layout;
  child(document.root, 0).name = "B";
  give_ids(document);
  EXPECT_EQ(document.layout, layout);
}

// Square growth would take minutes: CTest's time limit for this program ends it.
TEST(GiveIds, GivesEachOfManyElementsAnIdOfItsOwn) {
  Document document = rooted(R"({"state": "R"})");
  for (int i = 0; i < 100'000; ++i) {
    State state;
    state.name = "S" + std::to_string(i);
    document.root.children.emplace_back(std::move(state));
  }
  give_ids(document);
  const Document previous = document;
  give_ids(document, &previous);
  const auto ids = ids_in(document);
  EXPECT_EQ(std::set<std::string>(ids.begin(), ids.end()).size(), 100'001U);
}

/// Removes or repeats ids at random.
void disturb(State& state, std::mt19937& random) {
  const auto one_in = [&](std::uint32_t n) { return random() % n == 0; };
  if (one_in(3)) state.meta = Meta{};
  for (Port& port : state.ports) {
    if (one_in(3)) port.meta = state.meta;
  }
  for (Action& action : state.actions) {
    if (one_in(3)) action.meta = Meta{"same", Value()};
  }
  for (Node& node : state.children) {
    if (auto* inner = std::get_if<State>(&node)) disturb(*inner, random);
  }
}

TEST(GiveIds, LeavesNoElementWithoutAndNoTwoWithTheSame) {
  std::mt19937 random(11);
  for (const auto& folder : cases(false)) {
    const Document previous = with_ids(read_document_text(read_text(folder / "model.json")).value());
    for (int round = 0; round < 20; ++round) {
      Document document = previous;
      disturb(document.root, random);
      if (round % 2 == 0) document.library.push_back(document.root);
      give_ids(document, round % 4 < 2 ? &previous : nullptr);
      const auto ids = ids_in(document);
      ASSERT_EQ(std::set<std::string>(ids.begin(), ids.end()).size(), ids.size()) << folder << ", seed 11";
      ASSERT_EQ(with_ids(document, &previous), document) << folder << ", seed 11";
    }
  }
}

TEST(DerivedId, IsOfBothAndInOrder) {
  EXPECT_EQ(derived_id("link", "element").size(), 13U);
  EXPECT_TRUE(is_id(derived_id("link", "element")));
  EXPECT_NE(derived_id("link", "element"), derived_id("element", "link"));
  EXPECT_NE(derived_id("ab", "c"), derived_id("a", "bc"));
  EXPECT_EQ(derived_id("", "element"), "");
  EXPECT_EQ(derived_id("link", ""), "");
}

TEST(IsId, Takes1To64OfItsCharacters) {
  EXPECT_TRUE(is_id("aZ0_-"));
  EXPECT_TRUE(is_id(std::string(64, 'x')));
  for (const std::string& text :
       {std::string(), std::string(65, 'x'), std::string("a b"), std::string("\u00e4"), std::string("a.b")})
    EXPECT_FALSE(is_id(text)) << text;
}

}  // namespace
}  // namespace race::rcm
