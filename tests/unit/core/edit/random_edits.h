// Random edits of any tree, from a random source; some are refused.
#pragma once

#include <random>
#include <string>
#include <vector>

#include "core/edit/operation.h"
#include "core/edit/tree.h"
#include "core/rcm/ids.h"
#include "tests/unit/core/semantics/random_models.h"

namespace race::edit {

/// A random model as a document with ids.
inline rcm::Document random_document(std::uint64_t seed) {
  rcm::Document out;
  out.root = semantics::RandomModels(seed).model().root;
  rcm::give_ids(out);
  return out;
}

class RandomEdits {
 public:
  /// `prefix`: of the ids of what is inserted, one for each source.
  RandomEdits(std::uint64_t seed, std::string prefix) : random_(seed), prefix_(std::move(prefix)) {}

  /// One to three operations on what an author of `tree` sees.
  Edit edit(const Tree& tree) {
    const Ids all = tree.subtree(tree.root());
    Edit out;
    for (std::size_t i = 1 + (chance(0.3) ? pick(3) : 0); i > 0; --i) out.operations.push_back(operation(tree, all));
    return out;
  }

  std::size_t pick(std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random_); }
  bool chance(double p) { return std::uniform_real_distribution<double>(0, 1)(random_) < p; }

 private:
  static bool is_state(const Tree& tree, const std::string& id) {
    return std::holds_alternative<rcm::State>(tree.find(id)->content);
  }

  std::string state(const Tree& tree, const Ids& all) {
    for (;;) {
      const std::string& id = all[pick(all.size())];
      if (is_state(tree, id)) return id;
    }
  }

  Place place(const Tree& tree, const std::string& parent, ListName list) {
    const Ids& siblings = tree.list(parent, list);
    if (siblings.empty() || chance(0.3)) return {parent, list, std::nullopt};
    return {parent, list, siblings[pick(siblings.size())]};
  }

  Value node(ListName list, int depth) {
    const Dict meta{{"id", prefix_ + std::to_string(count_++)}};
    const std::string name = "N" + std::to_string(pick(5));
    if (list == ListName::actions) return Dict{{"when", "True"}, {"do", "var.v = 1"}, {"meta", meta}};
    if (list == ListName::ports) return Dict{{"name", name}, {"when", "True"}, {"meta", meta}};
    if (list != ListName::children) return Dict{{"name", name}, {"meta", meta}};
    if (chance(0.2)) return Dict{{"barrier", name}, {"to", List{}}, {"meta", meta}};
    Dict out{{"state", name}, {"meta", meta}};
    if (depth < 2 && chance(0.5)) out.set("children", List{node(ListName::children, depth + 1), node(list, depth + 1)});
    if (chance(0.5)) out.set("ports", List{node(ListName::ports, depth)});
    return out;
  }

  Set set(const Tree& tree, const Ids& all) {
    if (chance(0.1)) return {"", "layout", all[pick(all.size())], Value(static_cast<std::int64_t>(pick(9)))};
    const std::string& id = all[pick(all.size())];
    if (chance(0.2)) {
      const char* const keys[] = {"title", "icon", "min"};
      if (chance(0.3)) return {id, "meta", keys[pick(3)], std::nullopt};
      return {id, "meta", keys[pick(3)], Value(static_cast<std::int64_t>(pick(9)))};
    }
    const Content& content = tree.find(id)->content;
    const std::string name = "S" + std::to_string(pick(5));
    if (std::holds_alternative<rcm::Action>(content))
      return {id, "do", {}, Value("var.v = " + std::to_string(pick(9)))};
    if (std::holds_alternative<rcm::Port>(content) && chance(0.7)) {
      if (chance(0.3)) return {id, "to", {}, std::nullopt};
      return {id, "to", {}, Value(name)};
    }
    if (std::holds_alternative<rcm::State>(content) && chance(0.7)) return {id, "doc", {}, Value(name)};
    return {id, std::string(name_field(content)), {}, Value(name)};
  }

  Operation operation(const Tree& tree, const Ids& all) {
    static constexpr ListName kLists[] = {ListName::children, ListName::children, ListName::ports, ListName::actions,
                                          ListName::variables};
    const std::size_t what = pick(10);
    if (what < 3) {
      const ListName list = kLists[pick(5)];
      return Insert{place(tree, state(tree, all), list), node(list, 0)};
    }
    const std::string& id = all[pick(all.size())];
    if (what == 3) return Remove{id};
    if (what < 7) {
      const Element& element = *tree.find(id);
      const ListName list = element.list.value_or(ListName::children);
      return Move{id, place(tree, chance(0.5) ? element.parent : state(tree, all), list)};
    }
    return set(tree, all);
  }

  std::mt19937_64 random_;
  std::string prefix_;
  std::size_t count_ = 0;
};

}  // namespace race::edit
