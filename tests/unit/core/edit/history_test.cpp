// Edits that arrive late, undo and redo, each rule by itself.
#include "core/edit/history.h"

#include "tests/unit/core/edit/documents.h"

namespace race::edit {
namespace {

/// A history in which ann and bob edit the small document.
struct Session {
  History history;
  std::string first;

  explicit Session(HistoryLimits limits = {})
      : history(Tree::read(small_document()).value(), 0, limits), first(text()) {}

  std::string text() const { return text_of(history.tree()); }

  static std::string shown(const History::Result& result) {
    if (result) return "revision " + std::to_string((*result)->revision);
    const Rejection& reason = result.error();
    std::string out = reason.error.path + ": " + std::string(name(reason.error.code));
    if (reason.revision > 0) out += ", " + reason.author + " " + std::to_string(reason.revision);
    return out;
  }

  /// The revision, or the rejection; a rejected edit changes nothing.
  template <typename Act>
  std::string unless_rejected(Act act) {
    const std::string before = text();
    const Revision revision = history.revision();
    const auto result = act();
    if (!result) {
      EXPECT_EQ(text(), before);
      EXPECT_EQ(history.revision(), revision);
    }
    return shown(result);
  }

  std::string edit(const char* author, Revision base, const std::string& operation) {
    return unless_rejected([&] { return history.apply(author, base, edit_of("[{" + operation + "}]")); });
  }
  std::string undo(const char* author) {
    return unless_rejected([&] { return history.undo(author); });
  }
  std::string redo(const char* author) {
    return unless_rejected([&] { return history.redo(author); });
  }

  std::string children(const std::string& parent) const { return children_of(history.tree(), parent); }
  std::string doc(const std::string& id) const { return std::get<rcm::State>(history.tree().find(id)->content).doc; }
};

std::string insert(const std::string& id, const std::string& after, const std::string& parent = "r") {
  return "'op':'insert','parent':'" + parent + "','list':'children'," +
         (after.empty() ? "" : "'after':'" + after + "',") + "'node':{'state':'N','meta':{'id':'" + id + "'}}";
}
std::string move(const std::string& id, const std::string& after, const std::string& parent = "r") {
  return "'op':'move','id':'" + id + "','parent':'" + parent + "','list':'children'" +
         (after.empty() ? "" : ",'after':'" + after + "'");
}
std::string remove(const std::string& id) { return "'op':'remove','id':'" + id + "'"; }
std::string set_doc(const std::string& id, const std::string& doc) {
  return "'op':'set','id':'" + id + "','field':'doc','value':'" + doc + "'";
}

TEST(ALateEdit, MeetsARevisionThatIsThereAndRemembered) {
  Session s({.edits = 2});
  EXPECT_EQ(s.edit("ann", 1, set_doc("a", "x")), ": out_of_range");
  for (Revision i = 0; i < 4; ++i) s.edit("ann", i, set_doc("a", std::to_string(i)));
  EXPECT_EQ(s.edit("bob", 1, set_doc("b", "x")), ": conflict");
  EXPECT_EQ(s.edit("bob", 2, set_doc("b", "x")), "revision 5");
}

TEST(ALateInsert, StandsBehindTheSiblingThatItNamed) {
  Session s;
  EXPECT_EQ(s.edit("ann", 0, insert("n", "a")), "revision 1");
  EXPECT_EQ(s.edit("bob", 0, insert("m", "a")), "revision 2");
  EXPECT_EQ(s.children("r"), "a m n b c") << "the last in the server's order is the nearest";
}

TEST(ALateInsert, StandsWhereTheRemovedSiblingStood) {
  Session s;
  s.edit("ann", 0, remove("b"));
  EXPECT_EQ(s.edit("bob", 0, insert("m", "b")), "revision 2");
  EXPECT_EQ(s.children("r"), "a m c");
  s.edit("ann", 2, remove("a"));
  EXPECT_EQ(s.edit("bob", 0, insert("o", "a")), "revision 4");
  EXPECT_EQ(s.children("r"), "o m c") << "there is no sibling before it";
  s.edit("ann", 4, remove("c"));
  EXPECT_EQ(s.edit("bob", 4, insert("q", "c")), "revision 6");
  EXPECT_EQ(s.children("r"), "o m q") << "the nearest of those before it";
}

TEST(ALateInsert, StandsWhereASiblingStoodThatWasMovedAway) {
  Session s;
  s.edit("ann", 0, move("b", "", "a"));
  s.edit("bob", 0, insert("m", "b"));
  EXPECT_EQ(s.children("r"), "a m c");
  s.edit("ann", 2, move("a", "c"));
  s.edit("bob", 0, insert("o", "a"));
  EXPECT_EQ(s.children("r"), "m c a o") << "a sibling that is in the list still counts where it is";
}

TEST(ALateInsert, IsRejectedIfItsParentIsGone) {
  Session s;
  s.edit("ann", 0, remove("b"));
  EXPECT_EQ(s.edit("bob", 0, insert("m", "x", "b")), "operations/0/parent: conflict, ann 1");
  EXPECT_EQ(s.edit("bob", 1, insert("m", "b")), "operations/0/after: not_found") << "bob has seen that it is gone";
  EXPECT_EQ(s.edit("bob", 1, insert("m", "x")), "operations/0/after: not_found") << "it never stood there";
  EXPECT_EQ(s.edit("bob", 1, remove("a") + "}, {" + insert("m", "a")), "operations/1/after: not_found");
}

TEST(ALateRemoval, IsRejectedIfOthersHaveChangedWhatItWouldTakeAway) {
  for (const std::string& change : {set_doc("b", "new"), set_doc("x", "new"), insert("n", "", "x"), move("y", "", "b"),
                                    move("a", "", "x"), move("b", "")}) {
    SCOPED_TRACE(change);
    Session s;
    s.edit("ann", 0, change);
    EXPECT_EQ(s.edit("bob", 0, remove("b")), "operations/0/id: conflict, ann 1");
    EXPECT_EQ(s.edit("ann", 0, remove("b")), "revision 2") << "one's own edits are known";
  }
}

TEST(ALateRemoval, IsRejectedIfTheElementIsGone) {
  Session s;
  s.edit("ann", 0, remove("b"));
  EXPECT_EQ(s.edit("bob", 0, remove("b")), "operations/0/id: conflict, ann 1");
  EXPECT_EQ(s.edit("bob", 0, remove("x")), "operations/0/id: conflict, ann 1");
  EXPECT_EQ(s.edit("bob", 0, remove("nobody")), "operations/0/id: not_found");
}

TEST(ALateRemoval, TakesAwayWhatOthersHaveChangedAndTakenBack) {
  Session s;
  s.edit("ann", 0, set_doc("x", "new"));
  s.undo("ann");
  EXPECT_EQ(s.edit("bob", 1, remove("b")), "operations/0/id: conflict, ann 2") << "bob has seen the new text";
  EXPECT_EQ(s.edit("bob", 0, remove("b")), "revision 3");
}

TEST(ALateMove, IsRejectedIfTheElementWasMovedOrRemoved) {
  Session s;
  s.edit("ann", 0, move("a", "c"));
  EXPECT_EQ(s.edit("bob", 0, move("a", "b")), "operations/0/id: conflict, ann 1");
  EXPECT_EQ(s.edit("bob", 1, move("a", "b")), "revision 2");
  s.edit("ann", 2, remove("c"));
  EXPECT_EQ(s.edit("bob", 2, move("c", "")), "operations/0/id: conflict, ann 3");
}

TEST(ALateMove, IsRejectedIfItWouldCloseACircle) {
  Session s;
  s.edit("ann", 0, move("a", "", "x"));
  EXPECT_EQ(s.edit("bob", 0, move("b", "", "a")), "operations/0/parent: conflict, ann 1");
}

TEST(ALateSet, Wins) {
  Session s;
  s.edit("ann", 0, set_doc("a", "ann"));
  EXPECT_EQ(s.edit("bob", 0, set_doc("a", "bob")), "revision 2");
  EXPECT_EQ(s.doc("a"), "bob");
  s.edit("ann", 2, remove("a"));
  EXPECT_EQ(s.edit("bob", 2, set_doc("a", "x")), "operations/0/id: conflict, ann 3");
}

TEST(ARejectedEdit, LeavesNothingOfItself) {
  Session s;
  s.edit("ann", 0, remove("x"));
  const std::string before = s.text();
  const auto late = s.history.apply(
      "bob", 0,
      edit_of("[{" + insert("n", "b") + "}, {" + move("a", "n") + "}, {" + remove("c") + "}, {" + remove("x") + "}]"));
  EXPECT_EQ(Session::shown(late), "operations/3/id: conflict, ann 1");
  EXPECT_EQ(s.text(), before);
  EXPECT_EQ(s.edit("bob", 1, insert("n", "b")), "revision 2");
  EXPECT_EQ(s.children("r"), "a b n c");
}

TEST(Undo, TakesBackTheLatestEditOfItsAuthor) {
  Session s;
  s.edit("ann", 0, set_doc("a", "1"));
  s.edit("ann", 1, insert("n", "a"));
  s.edit("bob", 2, set_doc("b", "2"));
  EXPECT_EQ(s.undo("ann"), "revision 4");
  EXPECT_EQ(s.children("r"), "a b c");
  EXPECT_EQ(s.undo("ann"), "revision 5");
  EXPECT_EQ(s.doc("a"), "");
  EXPECT_EQ(s.undo("ann"), ": not_found");
  EXPECT_EQ(s.undo("bob"), "revision 6");
  EXPECT_EQ(s.text(), s.first);
  EXPECT_EQ(s.undo("nobody"), ": not_found");
}

TEST(Undo, LeavesWhatAnotherHasSetSince) {
  Session s;
  s.edit("ann", 0, set_doc("a", "ann"));
  s.edit("bob", 1, set_doc("a", "bob"));
  EXPECT_EQ(s.undo("ann"), "operations/0/field: conflict, bob 2");
  EXPECT_EQ(s.doc("a"), "bob");
}

TEST(Undo, IsAllOrNothing) {
  Session s;
  ASSERT_TRUE(s.history.apply("ann", 0, edit_of("[{" + set_doc("a", "1") + "}, {" + set_doc("b", "1") + "}]")));
  s.edit("bob", 1, set_doc("a", "2"));
  EXPECT_EQ(s.undo("ann"), "operations/1/field: conflict, bob 2");
  EXPECT_EQ(s.doc("b"), "1");
}

TEST(Undo, GoesOnBelowAnEditThatCannotBeTakenBack) {
  Session s;
  s.edit("ann", 0, set_doc("b", "first"));
  s.edit("ann", 1, set_doc("a", "second"));
  s.edit("bob", 2, set_doc("a", "bob"));
  EXPECT_EQ(s.undo("ann"), "operations/0/field: conflict, bob 3");
  EXPECT_EQ(s.undo("ann"), "revision 4");
  EXPECT_EQ(s.doc("b"), "");
  EXPECT_EQ(s.undo("bob"), "revision 5");
  EXPECT_EQ(s.undo("ann"), "revision 6") << "what was in the way is taken back";
  EXPECT_EQ(s.text(), s.first);
}

TEST(Undo, OfAnInsertKeepsWhatOthersHavePutThere) {
  for (const std::string& change : {set_doc("n", "bob"), insert("m", "", "n"), move("x", "", "n"), move("n", "")}) {
    SCOPED_TRACE(change);
    Session s;
    s.edit("ann", 0, insert("n", "a"));
    s.edit("bob", 1, change);
    EXPECT_EQ(s.undo("ann"), "operations/0/id: conflict, bob 2");
    s.undo("bob");
    s.undo("ann");
    EXPECT_EQ(s.text(), s.first);
  }
}

TEST(Undo, OfAnInsertKeepsTheWayBackOfWhatOthersHaveTakenOut) {
  for (const std::string& change : {move("m", "a"), remove("m")}) {
    SCOPED_TRACE(change);
    Session s;
    s.edit("ann", 0,
           "'op':'insert','parent':'r','list':'children','node':{'state':'N','meta':{'id':'n'},"
           "'children':[{'state':'M','meta':{'id':'m'}}]}");
    s.edit("bob", 1, change);
    EXPECT_EQ(s.undo("ann"), "operations/0/id: conflict, bob 2");
    s.undo("bob");
    s.undo("ann");
    EXPECT_EQ(s.text(), s.first);
  }
}

TEST(Undo, OfARemovalPutsTheElementBackBetweenItsSiblings) {
  Session s;
  s.edit("ann", 0, remove("b"));
  s.edit("bob", 1, move("a", "c"));
  s.edit("bob", 2, insert("n", "c"));
  EXPECT_EQ(s.undo("ann"), "revision 4");
  EXPECT_EQ(s.children("r"), "b c n a");
  s.undo("bob");
  s.undo("bob");
  EXPECT_EQ(s.text(), s.first) << "also the order of those that were not there together";
}

TEST(Undo, OfARemovalNeedsItsParent) {
  Session s;
  s.edit("ann", 0, remove("x"));
  s.edit("bob", 1, remove("b"));
  EXPECT_EQ(s.undo("ann"), "operations/0/parent: conflict, bob 2");
  s.undo("bob");
  s.undo("ann");
  EXPECT_EQ(s.text(), s.first);
}

TEST(Undo, OfAMoveIsRejectedIfAnotherHasMovedTheElementOnOrTheWayBackIsACircle) {
  Session s;
  s.edit("ann", 0, move("x", "a"));
  s.edit("bob", 1, move("x", "", "a"));
  EXPECT_EQ(s.undo("ann"), "operations/0/id: conflict, bob 2");
  s.edit("bob", 2, move("b", "", "x"));
  s.undo("bob");
  s.undo("bob");
  EXPECT_EQ(s.undo("ann"), "revision 6");
  EXPECT_EQ(s.text(), s.first);
  s.edit("ann", 6, move("x", "a"));
  s.edit("bob", 7, move("b", "", "x"));
  EXPECT_EQ(s.undo("ann"), "operations/0/parent: conflict, bob 8");
}

TEST(Redo, GivesAgainWhatWasTakenBack) {
  Session s;
  s.edit("ann", 0, insert("n", "a"));
  s.edit("ann", 1, set_doc("n", "text"));
  const std::string last = s.text();
  s.undo("ann");
  s.undo("ann");
  EXPECT_EQ(s.redo("ann"), "revision 5");
  EXPECT_EQ(s.redo("ann"), "revision 6");
  EXPECT_EQ(s.text(), last);
  EXPECT_EQ(s.redo("ann"), ": not_found");
  s.undo("ann");
  s.undo("ann");
  EXPECT_EQ(s.text(), s.first);
}

TEST(Redo, OfARemovalTakesWhatItsAuthorHasRedone) {
  Session s;
  s.edit("ann", 0, set_doc("x", "text"));
  s.edit("ann", 1, remove("b"));
  s.undo("ann");
  s.undo("ann");
  EXPECT_EQ(s.redo("ann"), "revision 5");
  EXPECT_EQ(s.redo("ann"), "revision 6");
  s.undo("ann");
  EXPECT_EQ(s.doc("x"), "text");
}

TEST(Redo, EndsWithTheNextEditOfItsAuthorAlone) {
  Session s;
  s.edit("ann", 0, set_doc("a", "1"));
  s.undo("ann");
  s.edit("bob", 2, set_doc("b", "1"));
  EXPECT_EQ(s.history.redo_depth("ann"), 1U);
  s.edit("ann", 3, set_doc("b", "2"));
  EXPECT_EQ(s.redo("ann"), ": not_found");
}

TEST(Redo, LeavesWhatAnotherHasSetSince) {
  Session s;
  s.edit("ann", 0, set_doc("a", "1"));
  s.undo("ann");
  s.edit("bob", 2, set_doc("a", "2"));
  EXPECT_EQ(s.redo("ann"), "operations/0/field: conflict, bob 3");
  s.undo("bob");
  EXPECT_EQ(s.redo("ann"), "revision 5");
}

TEST(History, ForgetsTheOldestEditsBeyondItsLimits) {
  Session s({.edits = 3});
  for (Revision i = 0; i < 5; ++i) s.edit("ann", i, insert("n" + std::to_string(i), "a"));
  EXPECT_EQ(s.history.log().size(), 3U);
  EXPECT_EQ(s.history.undo_depth("ann"), 3U);
  for (int i = 0; i < 5; ++i) s.undo("ann");
  EXPECT_EQ(s.children("r"), "a n2 n1 n0 b c") << "each undo is an edit that pushes an older one out";
}

TEST(History, ForgetsByTheSizeOfItsEditsButNeverTheLatest) {
  Session s({.edits = 100, .units = 3 * 2 * kOperationUnits});
  const std::string text(kOperationUnits, 'x');
  for (Revision i = 0; i < 3; ++i) s.edit("ann", i, set_doc("a", std::to_string(i)));
  EXPECT_EQ(s.history.log().size(), 2U) << "three of them and their texts are more than the limit";
  s.edit("ann", 3, set_doc("a", text + text + text + text + text));
  EXPECT_EQ(s.history.log().size(), 1U);
  EXPECT_EQ(s.undo("ann"), "revision 5");
  EXPECT_EQ(s.doc("a"), "2");
}

}  // namespace
}  // namespace race::edit
