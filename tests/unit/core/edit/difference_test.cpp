// The difference of two documents is the edit from one to the other, and no longer than it has to be.
#include "core/edit/difference.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>

#include "core/rcm/ids.h"
#include "tests/unit/core/edit/documents.h"
#include "tests/unit/core/edit/random_edits.h"
#include "tests/unit/core/semantics/random_models.h"
#include "tests/unit/setting.h"

namespace race::edit {
namespace {

/// Applies the difference to `from`, which is `to` then.
Edit checked_difference(const Tree& from, const Tree& to) {
  const auto edit = difference(from, to);
  EXPECT_TRUE(edit) << (edit ? "" : to_string(edit.error()));
  if (!edit) return {};
  Tree tree = from;
  const auto applied = apply(tree, *edit);
  EXPECT_TRUE(applied) << (applied ? "" : to_string(applied.error()));
  EXPECT_EQ(text_of(tree), text_of(to));
  return *edit;
}

/// The difference between the small document and itself after `operations`.
Edit found_again(const std::string& operations) {
  const Tree from = Tree::read(small_document()).value();
  Tree to = from;
  const auto applied = apply(to, edit_of(operations));
  EXPECT_TRUE(applied) << (applied ? "" : to_string(applied.error()));
  return checked_difference(from, to);
}

void expect_found_again(const std::string& operations) { EXPECT_EQ(found_again(operations), edit_of(operations)); }

TEST(Difference, OfADocumentAndItselfIsNothing) { expect_found_again("[]"); }

TEST(Difference, FindsEachOperationAgain) {
  expect_found_again("[{'op': 'set', 'id': 'adone', 'field': 'to', 'value': 'C'}]");
  expect_found_again("[{'op': 'set', 'id': 'adone', 'field': 'to'}]");
  expect_found_again("[{'op': 'set', 'id': 'a', 'field': 'meta', 'key': 'title', 'value': 'End'}]");
  expect_found_again("[{'op': 'set', 'id': '', 'field': 'notes', 'key': 'a', 'value': 'why'}]");
  expect_found_again("[{'op': 'set', 'id': '', 'field': 'layout', 'key': 'a'}]");
  expect_found_again("[{'op': 'remove', 'id': 'b'}]");
  expect_found_again("[{'op': 'move', 'id': 'y', 'parent': 'r', 'list': 'children', 'after': 'a'}]");
  expect_found_again(
      "[{'op': 'insert', 'parent': 'b', 'list': 'children', 'after': 'x', 'node': "
      "{'state': 'N', 'children': [{'state': 'M', 'meta': {'id': 'm'}}], 'meta': {'id': 'n'}}}]");
}

TEST(Difference, MovesTheFewestElementsOfAList) {
  expect_found_again("[{'op': 'move', 'id': 'c', 'parent': 'r', 'list': 'children'}]");
  expect_found_again("[{'op': 'move', 'id': 'a', 'parent': 'r', 'list': 'children', 'after': 'c'}]");
}

TEST(Difference, MovesWhatStaysOutOfWhatGoes) {
  const std::string moved = "{'op': 'move', 'id': 'y', 'parent': 'r', 'list': 'children', 'after': 'a'}";
  expect_found_again("[" + moved + ", {'op': 'remove', 'id': 'b'}]");
}

TEST(Difference, MovesWhatIsThereIntoWhatIsNew) {
  const Edit edit = found_again(
      "[{'op': 'insert', 'parent': 'r', 'list': 'children', 'node': {'state': 'G', 'meta': {'id': 'g'}}},"
      " {'op': 'move', 'id': 'a', 'parent': 'g', 'list': 'children'},"
      " {'op': 'move', 'id': 'b', 'parent': 'g', 'list': 'children', 'after': 'a'}]");
  EXPECT_EQ(edit.operations.size(), 3U);
}

TEST(Difference, TurnsAStateAndWhatIsInItInsideOut) {
  const Edit edit = found_again(
      "[{'op': 'move', 'id': 'x', 'parent': 'r', 'list': 'children'},"
      " {'op': 'move', 'id': 'b', 'parent': 'x', 'list': 'children'}]");
  EXPECT_EQ(edit.operations.size(), 2U);
}

TEST(Difference, ReplacesAnElementWhoseIdIsNowOfAnotherKind) {
  const Edit edit = found_again(
      "[{'op': 'remove', 'id': 'b'}, {'op': 'remove', 'id': 'v'},"
      " {'op': 'insert', 'parent': 'r', 'list': 'results', 'node': {'name': 'v', 'meta': {'id': 'v'}}},"
      " {'op': 'insert', 'parent': 'r', 'list': 'children', 'node': {'barrier': 'B', 'to': [], 'meta': {'id': 'b'}}},"
      " {'op': 'insert', 'parent': 'a', 'list': 'children', 'node': {'state': 'X', 'meta': {'id': 'x'}}}]");
  EXPECT_EQ(edit.operations.size(), 5U);
}

TEST(Difference, SeesTheOrderOfEntriesInAValue) {
  const Tree from = Tree::read(small_document()).value();
  Tree one = from, other = from;
  ASSERT_TRUE(apply(one, edit_of("[{'op': 'set', 'id': 'p', 'field': 'value', 'value': {'a': 1, 'b': 2}}]")));
  ASSERT_TRUE(apply(other, edit_of("[{'op': 'set', 'id': 'p', 'field': 'value', 'value': {'b': 2, 'a': 1}}]")));
  EXPECT_EQ(checked_difference(one, other).operations.size(), 1U);
}

TEST(Difference, IsRefusedWhereNoEditCouldDoIt) {
  const Tree from = Tree::read(small_document()).value();
  const auto to = [](const std::string& text) { return Tree::read(document_of(json(text))).value(); };
  const auto other = difference(from, to("{'rcm': 1, 'root': {'state': 'R', 'meta': {'id': 'other'}}}"));
  ASSERT_FALSE(other);
  EXPECT_EQ(other.error().code, ErrorCode::not_accepted);
  const auto text = difference(from, to("{'rcm': 1, 'root': {'state': 'R', 'meta': {'id': 'r'}}, 'meta': 'text'}"));
  ASSERT_FALSE(text);
  EXPECT_EQ(text.error().code, ErrorCode::not_accepted);
}

TEST(Difference, IsRefusedBeyondTheBoundOfAnEdit) {
  const auto with_services = [](std::size_t count) {
    rcm::Document document = small_document();
    for (std::size_t i = 0; i < count; ++i) document.services["s" + std::to_string(i)] = "robot";
    return Tree::read(document).value();
  };
  const Tree from = with_services(0);
  EXPECT_EQ(checked_difference(from, with_services(kMaxOperations)).operations.size(), kMaxOperations);
  const auto edit = difference(from, with_services(kMaxOperations + 1));
  ASSERT_FALSE(edit);
  EXPECT_EQ(edit.error().code, ErrorCode::too_large);
}

TEST(Difference, OfRandomlyEditedDocumentsLeadsFromEachToEach) {
  const std::uint64_t seed = setting("RACE_SEED", 20261122);
  const std::uint64_t documents = setting("RACE_DOCUMENTS", 15);
  std::cout << "RACE_SEED=" << seed << " RACE_DOCUMENTS=" << documents << std::endl;
  std::size_t operations = 0;
  for (std::uint64_t i = 0; i < documents && !testing::Test::HasFailure(); ++i) {
    SCOPED_TRACE("RACE_SEED=" + std::to_string(seed + i));
    rcm::Document document;
    document.root = semantics::RandomModels(seed + i).model().root;
    rcm::give_ids(document);
    RandomEdits edits(seed + i, "n");
    Tree from = Tree::read(document).value(), to = from;
    std::size_t edited = 0;  // operations between the two
    for (int round = 0; round < 10 && !testing::Test::HasFailure(); ++round) {
      for (std::size_t k = edits.pick(40); k > 0; --k) {
        const Edit edit = edits.edit(to);
        if (apply(to, edit)) edited += edit.operations.size();
      }
      const std::size_t found = checked_difference(from, to).operations.size();
      EXPECT_LE(found, edited);
      checked_difference(to, from);
      operations += found;
      if (!edits.chance(0.5)) continue;
      from = to;
      edited = 0;
    }
  }
  std::cout << operations << " operations\n";
  EXPECT_GT(operations, 10 * documents);
}

}  // namespace
}  // namespace race::edit
