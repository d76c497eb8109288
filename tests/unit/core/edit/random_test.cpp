// Several authors edit one random model, late, with undo and redo, and restore what it was: every replica that applies
// what was accepted has the same document, and undo of everything gives the first one.
#include <gtest/gtest.h>

#include <iostream>

#include "core/edit/difference.h"
#include "core/edit/history.h"
#include "tests/unit/core/edit/documents.h"
#include "tests/unit/core/edit/random_edits.h"
#include "tests/unit/setting.h"

namespace race::edit {
namespace {

/// One who edits: their replica is some revisions behind the server.
struct Author {
  std::string name;
  Tree replica;
  Revision revision = 0;
  RandomEdits edits;
};

class EditingSimulation {
 public:
  EditingSimulation(std::uint64_t seed, std::size_t authors)
      : random_(seed, "r"), history_(Tree::read(random_document(seed)).value(), 0, {.edits = 100'000}) {
    revisions_.push_back(history_.tree());
    first_ = text_of(history_.tree());
    for (std::size_t i = 0; i < authors; ++i) {
      const std::string name = "author" + std::to_string(i);
      authors_.push_back({name, history_.tree(), 0, RandomEdits(seed * 31 + i, name + "-")});
    }
  }

  void act() {
    Author& author = authors_[random_.pick(authors_.size())];
    if (random_.chance(0.4)) follow(author, author.revision + random_.pick(8));
    History::Result result = step(author);
    if (result) revisions_.push_back(history_.tree());
    ++(result ? accepted_ : rejected_);
    if (!result && result.error().revision > 0) ++conflicts_;
  }

  /// Everybody hears of everything: all have the server's document, and so has who reads the server's.
  void expect_agreement() {
    const std::string text = text_of(history_.tree());
    for (Author& author : authors_) {
      follow(author, history_.revision());
      ASSERT_EQ(text_of(author.replica), text) << author.name;
    }
    ASSERT_EQ(text_of(Tree::read(history_.tree().document()).value()), text);
  }

  /// Every author takes everything back, in any order between them.
  void undo_everything() {
    for (std::size_t left = 1; left > 0;) {
      left = 0;
      bool progress = false;
      for (std::size_t i = random_.pick(authors_.size()), n = 0; n < authors_.size(); ++n) {
        const Author& author = authors_[(i + n) % authors_.size()];
        for (std::size_t k = random_.pick(4); k < 4; ++k) progress = history_.undo(author.name).has_value() || progress;
        left += history_.undo_depth(author.name);
      }
      ASSERT_TRUE(progress || left == 0 || ++stuck_ < 100) << "nobody can undo anything";
    }
    ASSERT_EQ(text_of(history_.tree()), first_);
  }

  /// The latest edit first, whoever made it: none is rejected.
  void undo_in_reverse() {
    for (std::size_t i = history_.log().size(); i > 0; --i) {
      const LogEntry& entry = history_.log()[i - 1];
      if (!entry.in_effect) continue;
      const auto undone = history_.undo(entry.accepted.author);
      ASSERT_TRUE(undone) << to_string(undone.error().error);
      ASSERT_EQ((*undone)->of, i);
    }
    ASSERT_EQ(text_of(history_.tree()), first_);
  }

  std::size_t accepted() const { return accepted_; }
  std::size_t rejected() const { return rejected_; }
  std::size_t conflicts() const { return conflicts_; }
  bool chance(double p) { return random_.chance(p); }

 private:
  History::Result step(Author& author) {
    if (random_.chance(0.15)) return history_.undo(author.name);
    if (random_.chance(0.1)) return history_.redo(author.name);
    if (random_.chance(0.1)) return restore(author);
    return history_.apply(author.name, author.revision, author.edits.edit(author.replica));
  }

  /// Makes one of the last revisions again: what was removed since comes back under the ids that it had.
  History::Result restore(const Author& author) {
    const Revision last = history_.revision();
    const Tree& then = revisions_[last - std::min(last, 1 + random_.pick(12))];
    return history_.apply(author.name, last, difference(history_.tree(), then).value());
  }

  void follow(Author& author, Revision revision) {
    for (; author.revision < std::min(revision, history_.revision()); ++author.revision) {
      const auto applied = apply(author.replica, history_.log()[author.revision].accepted.edit);
      ASSERT_TRUE(applied) << to_string(applied.error());
      ASSERT_EQ(*applied, history_.log()[author.revision].accepted.inverse);
    }
  }

  RandomEdits random_;
  History history_;
  std::string first_;
  std::vector<Tree> revisions_;  // the document after each edit, from the first one on
  std::vector<Author> authors_;
  std::size_t accepted_ = 0, rejected_ = 0, conflicts_ = 0, stuck_ = 0;
};

TEST(RandomEdits, ReplicasAgreeAndUndoOfEverythingGivesTheFirstDocument) {
  const std::uint64_t seed = setting("RACE_SEED", 20261122);
  const std::uint64_t simulations = setting("RACE_SIMULATIONS", 16);
  std::cout << "RACE_SEED=" << seed << " RACE_SIMULATIONS=" << simulations << std::endl;
  std::size_t accepted = 0, rejected = 0, conflicts = 0;
  for (std::uint64_t i = 0; i < simulations && !testing::Test::HasFatalFailure(); ++i) {
    SCOPED_TRACE("RACE_SEED=" + std::to_string(seed + i));
    EditingSimulation simulation(seed + i, 2 + i % 7);
    for (std::size_t k = 0; k < 150 && !testing::Test::HasFatalFailure(); ++k) {
      simulation.act();
      if (simulation.chance(0.02)) simulation.expect_agreement();
    }
    simulation.expect_agreement();
    i % 2 == 0 ? simulation.undo_everything() : simulation.undo_in_reverse();
    simulation.expect_agreement();
    accepted += simulation.accepted();
    rejected += simulation.rejected();
    conflicts += simulation.conflicts();
  }
  std::cout << accepted << " accepted, " << rejected << " rejected, " << conflicts
            << " of them because of another's edit\n";
  EXPECT_GT(accepted, rejected);
  EXPECT_GT(conflicts, simulations);
}

}  // namespace
}  // namespace race::edit
