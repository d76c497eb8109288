#include "core/edit/apply.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "core/edit/extent.h"

namespace race::edit {
namespace {

struct Apply {
  Tree& tree;
  Expected<Operation> operator()(const Insert& o) const { return tree.insert(o); }
  Expected<Operation> operator()(const Remove& o) const { return tree.remove(o); }
  Expected<Operation> operator()(const Move& o) const { return tree.move(o); }
  Expected<Operation> operator()(const Set& o) const { return tree.set(o); }
};

}  // namespace

Expected<Operation> apply(Tree& tree, const Operation& operation) { return std::visit(Apply{tree}, operation); }

void apply_known(Tree& tree, const Edit& edit) {
  for (const Operation& operation : edit.operations) {
    [[maybe_unused]] const auto applied = apply(tree, operation);
    assert(applied);
  }
}

Expected<Edit> apply(Tree& tree, const Edit& edit) {
  Edit inverse;
  const auto refused = [&](Error error) -> Expected<Edit> {
    std::ranges::reverse(inverse.operations);
    apply_known(tree, inverse);
    return tl::unexpected(std::move(error));
  };
  for (std::size_t i = 0; i < edit.operations.size(); ++i) {
    auto undo = apply(tree, edit.operations[i]);
    if (!undo) {
      undo.error().path = "operations/" + std::to_string(i) + "/" + undo.error().path;
      return refused(std::move(undo).error());
    }
    inverse.operations.push_back(std::move(*undo));
  }
  if (auto fits = check_extent(tree); !fits) return refused(std::move(fits).error());
  std::ranges::reverse(inverse.operations);
  return inverse;
}

Expected<Applied> apply(const rcm::Document& document, const Edit& edit) {
  ASSIGN_OR_RETURN(Tree tree, Tree::read(document));
  ASSIGN_OR_RETURN(Edit inverse, apply(tree, edit));
  return Applied{tree.document(), std::move(inverse)};
}

}  // namespace race::edit
