// Random mutations of edits as JSON: reading and applying never crashes, and what is applied can be taken back.
#include <array>
#include <iostream>

#include "core/edit/history.h"
#include "tests/unit/core/edit/documents.h"
#include "tests/unit/core/edit/random_edits.h"
#include "tests/unit/core/execution/mutator.h"
#include "tests/unit/setting.h"

namespace race::edit {
namespace {

constexpr std::array<const char*, 24> kWords = {"a",      "b",     "r",     "x",  "adone",   "",     "set",   "move",
                                                "parent", "list",  "after", "id", "node",    "meta", "field", "key",
                                                "value",  "state", "ports", "to", "library", "doc",  "notes", "x y"};

TEST(EditFuzz, AMutatedEditIsRefusedOrAppliedAndTakenBack) {
  const std::uint64_t seed = setting("RACE_SEED", 20261122);
  const std::uint64_t mutations = setting("RACE_MUTATIONS", 2'000);
  std::cout << "RACE_SEED=" << seed << " RACE_MUTATIONS=" << mutations << std::endl;
  const Tree tree = Tree::read(small_document()).value();
  const std::string before = text_of(tree);
  std::size_t read = 0, applied = 0;
  for (std::uint64_t i = 0; i < mutations && !testing::Test::HasFailure(); ++i) {
    SCOPED_TRACE("RACE_SEED=" + std::to_string(seed) + ", mutation " + std::to_string(i));
    Value json = write_edit(RandomEdits(seed + i, "n").edit(tree));
    execution::Mutator mutator(seed + i, kWords);
    for (std::size_t k = mutator.below(3); k > 0; --k) mutator.mutate(json);
    const auto edit = read_edit(json);
    if (!edit) {
      EXPECT_FALSE(edit.error().empty());
      continue;
    }
    ++read;
    History history(tree);
    const auto result = history.apply("ann", 0, *edit);
    EXPECT_EQ(result.has_value(), apply(small_document(), *edit).has_value()) << "with and without a history";
    if (result) {
      ++applied;
      const auto again = Tree::read(history.tree().document());
      ASSERT_TRUE(again);
      EXPECT_EQ(text_of(*again), text_of(history.tree()));
      EXPECT_TRUE(rcm::write_document_text(history.tree().document()));
      EXPECT_TRUE(history.undo("ann"));
    }
    EXPECT_EQ(text_of(history.tree()), before);
  }
  EXPECT_GT(read, mutations / 10);
  EXPECT_GT(applied, mutations / 10);
}

}  // namespace
}  // namespace race::edit
