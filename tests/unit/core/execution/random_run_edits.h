// Random edits of a document that runs: what people change in a task, so that most of them leave a task that can run.
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "core/edit/compound.h"
#include "tests/unit/core/edit/random_edits.h"

namespace race::execution {

class RandomRunEdits {
 public:
  RandomRunEdits(std::uint64_t seed, const std::string& prefix) : random_(seed, prefix), prefix_(prefix + "n") {}

  edit::Edit edit(const edit::Tree& tree) {
    if (chance(0.15)) return random_.edit(tree);
    if (chance(0.2))
      if (auto compound = this->compound(tree)) return std::move(*compound);
    if (chance(0.15)) return leaving(tree);
    return {{operation(tree)}};
  }
  bool chance(double p) { return random_.chance(p); }

 private:
  using Ids = edit::Ids;
  using List = edit::ListName;
  std::size_t pick(std::size_t n) { return random_.pick(n); }
  std::string number(std::size_t n) { return std::to_string(pick(n)); }
  std::string new_id() { return prefix_ + std::to_string(count_++); }
  Dict meta() { return {{"id", new_id()}}; }
  template <typename Content>
  std::optional<std::string> any(const edit::Tree& tree) {
    Ids found;
    for (const std::string& id : tree.subtree(tree.root()))
      if (std::holds_alternative<Content>(tree.find(id)->content)) found.push_back(id);
    return found.empty() ? std::nullopt : std::optional(found[pick(found.size())]);
  }
  std::string any_state(const edit::Tree& tree) { return any<rcm::State>(tree).value(); }
  edit::Place place(const edit::Tree& tree, const std::string& state, List list) {
    const Ids& siblings = tree.list(state, list);
    if (siblings.empty() || chance(0.3)) return {state, list, std::nullopt};
    return {state, list, siblings[pick(siblings.size())]};
  }
  static std::string name_of(const edit::Tree& tree, const std::string& id) {
    const auto node = tree.find(id);
    const auto* state = std::get_if<rcm::State>(&node->content);
    return state ? state->name : std::get<rcm::Barrier>(node->content).name;
  }
  std::string condition() {
    switch (pick(6)) {
      case 0:
        return "svc.t.e" + number(4);
      case 1:
        return "svc.t.o" + number(2) + ".result";
      case 2:
        return "svc[('t', 'u')[0] if var.v else 'w'].o0.error";
      case 3:
        return "var.v > " + number(3);
      case 4:
        return "True";
      default:
        return "available(svc.u.o" + number(2) + ".result) and res.r == " + number(3);
    }
  }
  std::string function() {
    switch (pick(5)) {
      case 0:
        return "svc.t.o" + number(2) + "(" + number(9) + ")";
      case 1:
        return "var.v = (var.v + 1) % 4";
      case 2:
        return "res.r = par.p\nsvc['w'].o0()";
      case 3:
        return "svc.u.o" + number(2) + "(par.p)";
      default:
        return "var.w = " + number(4);
    }
  }

  std::optional<edit::Edit> compound(const edit::Tree& tree) {
    const std::string id = any_state(tree);
    Expected<edit::Edit> edit = edit::Edit{};
    switch (pick(4)) {
      case 0:
        edit = edit::rename(tree, id, "M" + number(9));
        break;
      case 1:
        if (tree.size() < 150) edit = edit::duplicate(tree, id, new_id());
        break;
      case 2:
        edit = edit::group(tree, {id}, "G" + number(9), new_id());
        break;
      default:
        edit = edit::ungroup(tree, id);
    }
    return edit ? std::optional(std::move(*edit)) : std::nullopt;
  }

  // A state is removed, or moved into another one, after what leads to it leads elsewhere.
  edit::Edit leaving(const edit::Tree& tree) {
    const std::string id = any_state(tree);
    const std::string& parent = tree.find(id)->parent;
    if (parent.empty()) return {{operation(tree)}};
    const std::string name = name_of(tree, id);
    edit::Edit out;
    for (const std::string& sibling : tree.list(parent, List::children)) {
      if (const auto* barrier = std::get_if<rcm::Barrier>(&tree.find(sibling)->content)) {
        race::List to;
        for (const std::string& target : barrier->to)
          if (target != name) to.emplace_back(target);
        out.operations.emplace_back(edit::Set{sibling, "to", {}, Value(std::move(to))});
      }
      for (const std::string& port : tree.list(sibling, List::ports))
        if (std::get<rcm::Port>(tree.find(port)->content).to == name || sibling == id)
          out.operations.emplace_back(edit::Set{port, "to", {}, std::nullopt});
    }
    if (std::get<rcm::State>(tree.find(parent)->content).first == name)
      out.operations.emplace_back(edit::Set{parent, "first", {}, std::nullopt});
    const std::string other = any_state(tree);
    if (chance(0.5) && !tree.is_below(id, other))
      out.operations.emplace_back(edit::Move{id, place(tree, other, List::children)});
    else
      out.operations.emplace_back(edit::Remove{id});
    return out;
  }

  edit::Operation operation(const edit::Tree& tree) {
    const std::string state = any_state(tree);
    switch (pick(12)) {
      case 0: {
        const Value from = chance(0.5) ? Value("par.p") : Value("var.v");
        Dict node{{"name", "q" + number(4)}, {"meta", meta()}};
        if (chance(0.9)) chance(0.5) ? node.set("from", from) : node.set("value", static_cast<std::int64_t>(pick(5)));
        return edit::Insert{place(tree, state, List::parameters), std::move(node)};
      }
      case 1: {
        Dict node{{"name", "w"}, {"meta", meta()}};
        if (chance(0.5)) node.set("initial", static_cast<std::int64_t>(pick(5)));
        return edit::Insert{place(tree, state, List::variables), std::move(node)};
      }
      case 2:
        return edit::Insert{place(tree, state, List::actions),
                            Dict{{"when", condition()}, {"do", function()}, {"meta", meta()}}};
      case 3:
        return edit::Insert{place(tree, state, List::ports),
                            Dict{{"name", "n" + number(99)}, {"when", condition()}, {"meta", meta()}}};
      case 4:
        return edit::Insert{place(tree, state, List::children),
                            Dict{{"state", "N" + number(99)},
                                 {"parameters", edit_list(Dict{{"name", "p"}, {"value", 1}, {"meta", meta()}})},
                                 {"ports", edit_list(Dict{{"name", "p0"}, {"when", condition()}, {"meta", meta()}})},
                                 {"meta", meta()}}};
      case 5:
        if (const auto action = any<rcm::Action>(tree))
          return chance(0.5) ? edit::Set{*action, "do", {}, Value(function())}
                             : edit::Set{*action, "when", {}, Value(condition())};
        break;
      case 6:
        if (const auto datum = any<rcm::Datum>(tree)) {
          if (chance(0.3)) return edit::Set{*datum, "initial", {}, std::nullopt};
          return edit::Set{*datum, "initial", {}, Value(static_cast<std::int64_t>(pick(5)))};
        }
        break;
      case 7:
      case 8:
        return target(tree, state);
      case 9:
        return edit::Remove{removable(tree)};
      case 10: {  // in its own list
        const Ids all = tree.subtree(tree.root());
        const std::string& id = all[pick(all.size())];
        const edit::Element& element = *tree.find(id);
        if (element.list) return edit::Move{id, place(tree, element.parent, *element.list)};
        break;
      }
      default:
        break;
    }
    if (chance(0.5)) return edit::Set{state, "keep", {}, chance(0.7) ? std::optional(Value(true)) : std::nullopt};
    return first(tree, state);
  }
  static race::List edit_list(Dict item) { return {Value(std::move(item))}; }

  // A port leads to another sibling, or nowhere; a barrier leads to other states.
  edit::Operation target(const edit::Tree& tree, const std::string& state) {
    if (const auto port = any<rcm::Port>(tree); port && chance(0.8)) {
      const std::string& parent = tree.find(tree.find(*port)->parent)->parent;
      const Ids& siblings = tree.list(parent, List::children);
      if (parent.empty() || siblings.empty() || chance(0.2)) return edit::Set{*port, "to", {}, std::nullopt};
      return edit::Set{*port, "to", {}, Value(name_of(tree, siblings[pick(siblings.size())]))};
    }
    if (const auto barrier = any<rcm::Barrier>(tree)) {
      race::List to;
      for (const std::string& sibling : tree.list(tree.find(*barrier)->parent, List::children))
        if (std::holds_alternative<rcm::State>(tree.find(sibling)->content) && chance(0.5))
          to.emplace_back(name_of(tree, sibling));
      return edit::Set{*barrier, "to", {}, Value(std::move(to))};
    }
    return first(tree, state);
  }
  edit::Operation first(const edit::Tree& tree, const std::string& state) {
    const Ids& children = tree.list(state, List::children);
    if (children.empty()) return edit::Set{state, "doc", {}, Value(number(9))};
    return edit::Set{state, "first", {}, Value(name_of(tree, children[pick(children.size())]))};
  }
  std::string removable(const edit::Tree& tree) {
    if (chance(0.25)) return any_state(tree);
    if (chance(0.3)) return any<rcm::Port>(tree).value_or(tree.root());
    if (chance(0.5)) return any<rcm::Action>(tree).value_or(tree.root());
    if (chance(0.5)) return any<rcm::Barrier>(tree).value_or(tree.root());
    return chance(0.5) ? any<rcm::Datum>(tree).value_or(tree.root()) : any<rcm::Parameter>(tree).value();
  }

  edit::RandomEdits random_;
  std::string prefix_;
  std::size_t count_ = 0;
};

}  // namespace race::execution
