// What a document is found to violate after each of many edits is the same with the checks of the revision before
// (rcm::CodeChecks) and without.
#include <gtest/gtest.h>

#include "core/edit/history.h"
#include "core/rcm/constraints.h"
#include "tests/unit/core/edit/documents.h"
#include "tests/unit/core/edit/random_edits.h"
#include "tests/unit/setting.h"

namespace race::edit {
namespace {

/// Edits of names and of code that uses them: what is declared decides what the code of others violates.
class ScopeEdits {
 public:
  explicit ScopeEdits(std::uint64_t seed) : random_(seed, "scope") {}

  Edit edit(const Tree& tree) {
    const Ids all = tree.subtree(tree.root());
    const std::string& id = all[random_.pick(all.size())];
    const Content& content = tree.find(id)->content;
    if (std::holds_alternative<rcm::Port>(content)) return {{Set{id, "when", {}, Value(text())}}};
    if (std::holds_alternative<rcm::Action>(content))
      return {{Set{id, random_.chance(0.5) ? "when" : "do", {}, Value(text())}}};
    if (std::holds_alternative<rcm::Parameter>(content)) return {{Set{id, "from", {}, Value(text())}}};
    if (!std::holds_alternative<rcm::State>(content)) return random_.edit(tree);
    if (random_.chance(0.3)) return {{Set{id, "entry", {}, Value(text())}}};
    const auto list = random_.chance(0.5) ? ListName::results : ListName::parameters;
    return {{Insert{{id, list, {}}, Dict{{"name", name()}, {"meta", Dict{{"id", "s" + std::to_string(count_++)}}}}}}};
  }

 private:
  std::string name() { return "n" + std::to_string(random_.pick(4)); }
  std::string text() {
    static constexpr const char* kTexts[] = {"par.", "res.", "port.", "chi.", "var.", "chi.S0.par.", "svc.t.", "(", ""};
    return kTexts[random_.pick(std::size(kTexts))] + name();
  }

  RandomEdits random_;
  std::size_t count_ = 0;
};

TEST(CodeChecks, FindTheSameAsWithoutThemAfterEveryEdit) {
  std::size_t edits = 0, with_names = 0, with_violations = 0;
  for (std::uint64_t seed = 0; seed < sample(40); ++seed) {
    History history(Tree::read(random_document(seed)).value());
    RandomEdits any(seed, "any");
    ScopeEdits scopes(seed);
    rcm::CodeChecks checks;
    for (int i = 0; i < 60; ++i) {
      if (any.chance(0.3)) {
        history.undo("a");
      } else {
        history.apply("a", history.revision(),
                      any.chance(0.3) ? any.edit(history.tree()) : scopes.edit(history.tree()));
      }
      const rcm::Document document = history.tree().document();
      const std::vector<Error> expected = rcm::violations(document);
      ASSERT_EQ(rcm::violations(document, checks), expected) << "seed " << seed << ", edit " << i;
      ASSERT_EQ(rcm::violations(document, checks), expected) << "again; seed " << seed << ", edit " << i;
      const auto is_unknown = [](const Error& error) { return error.code == ErrorCode::unknown_name; };
      ++edits;
      with_violations += expected.empty() ? 0 : 1;
      with_names += std::ranges::any_of(expected, is_unknown) ? 1 : 0;
    }
  }
  EXPECT_GT(with_violations, edits / 4);
  EXPECT_GT(with_names, edits / 10);
}

/// The document of documents.h has two texts of an action, `when` and `do`, and one of each of two ports.
constexpr std::size_t kTexts = 4;

TEST(CodeChecks, ReadTheTextThatWasEditedAlone) {
  History history(Tree::read(small_document()).value());
  rcm::CodeChecks checks;
  const auto reads_after = [&](Set set) {
    const std::size_t before = checks.reads();
    EXPECT_TRUE(history.apply("a", history.revision(), Edit{{std::move(set)}}));
    rcm::violations(history.tree().document(), checks);
    return checks.reads() - before;
  };
  EXPECT_EQ(reads_after({"adone", "when", {}, Value("False")}), kTexts);
  EXPECT_EQ(reads_after({"adone", "when", {}, Value("1 > 0")}), 1U);
  EXPECT_EQ(reads_after({"a", "doc", {}, Value("Another")}), 0U);
  EXPECT_EQ(reads_after({"p", "name", {}, Value("q")}), 2U) << "the texts of the state whose parameter it is";
}

TEST(CodeChecks, ReadNoTextAgainBecauseOfAViolationOfStructure) {
  History history(Tree::read(small_document()).value());
  rcm::CodeChecks checks;
  rcm::violations(history.tree().document(), checks);
  const std::size_t before = checks.reads();
  for (const char* target : {"Nowhere", "B", "Elsewhere"}) {
    ASSERT_TRUE(history.apply("a", history.revision(), Edit{{Set{"adone", "to", {}, Value(target)}}}));
    rcm::violations(history.tree().document(), checks);
    EXPECT_EQ(checks.reads(), before) << target;
  }
}

TEST(CodeChecks, HoldWhatTheLastDocumentHadAndNoMore) {
  History history(Tree::read(small_document()).value());
  rcm::CodeChecks checks;
  for (int i = 0; i < 100; ++i) {
    const std::string text = "True or " + std::to_string(i) + " > 0";
    ASSERT_TRUE(history.apply("a", history.revision(), Edit{{Set{"adone", "when", {}, Value(text)}}}));
    rcm::violations(history.tree().document(), checks);
    EXPECT_EQ(checks.size(), kTexts);
  }
  rcm::violations(rcm::Document{}, checks);
  EXPECT_EQ(checks.size(), 0U);
}

}  // namespace
}  // namespace race::edit
