#include "core/semantics/correspondence.h"

#include <numeric>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <utility>

namespace race::semantics {
namespace {

/// Elements of one owner before the edit, found by id, and where one of two has none, by name.
class Siblings {
 public:
  void add(const std::string& id, const std::string& name, std::uint32_t number) {
    if (!id.empty()) by_id_.emplace(id, number);
    by_name_.emplace(name, std::pair(number, id.empty()));
  }
  /// kNone: there is none that has not been found before.
  std::uint32_t take(const std::string& id, const std::string& name) {
    const std::uint32_t same = find(id, name);
    return same != kNone && taken_.insert(same).second ? same : kNone;
  }

 private:
  std::uint32_t find(const std::string& id, const std::string& name) const {
    if (const auto same = by_id_.find(id); !id.empty() && same != by_id_.end()) return same->second;
    const auto same = by_name_.find(name);
    return same != by_name_.end() && (id.empty() || same->second.second) ? same->second.first : kNone;
  }

  std::unordered_map<std::string_view, std::uint32_t> by_id_;
  std::unordered_map<std::string_view, std::pair<std::uint32_t, bool>> by_name_;  // whether it has no id
  std::unordered_set<std::uint32_t> taken_;
};

class Matcher {
 public:
  Matcher(const Program& before, const Program& after, Correspondence& same) : old_(before), new_(after), same_(same) {}

  // Parents come before their children: an element that has moved to another one is new.
  void match() {
    Siblings root;
    root.add(old_.id(Program::root), old_[Program::root].name, index(Program::root));
    same_.states[0] = root.take(new_.id(Program::root), new_[Program::root].name);
    for (std::uint32_t s = 0; s < new_.states.size(); ++s)
      if (same_.states[s] != kNone) match_below(new_[StateId{s}], old_[StateId{same_.states[s]}]);
  }

 private:
  void match_below(const StateInfo& info, const StateInfo& before) {
    match_children(info, before);
    match_ports(info, before);
    match_values(parameter_names(info), info.first_parameter, parameter_names(before), before.first_parameter);
    match_values(info.results, info.first_result, before.results, before.first_result);
    match_values(info.variables, info.first_variable, before.variables, before.first_variable);
    match_actions(info, before);
  }

  void match_children(const StateInfo& info, const StateInfo& before) {
    Siblings states, barriers;
    for (const NodeRef child : before.children)
      (child.barrier ? barriers : states).add(id(old_, child), name(old_, child), child.number);
    for (const NodeRef child : info.children)
      (child.barrier ? same_.barriers : same_.states)[child.number] =
          (child.barrier ? barriers : states).take(id(new_, child), name(new_, child));
  }
  static const std::string& id(const Program& program, NodeRef node) {
    return node.barrier ? program.id(node.as_barrier()) : program.id(node.state());
  }
  static const std::string& name(const Program& program, NodeRef node) {
    return node.barrier ? program[node.as_barrier()].name : program[node.state()].name;
  }

  void match_ports(const StateInfo& info, const StateInfo& before) {
    Siblings ports;
    for (const PortId p : before.ports) ports.add(old_.id(p), old_[p].name, index(p));
    for (const PortId p : info.ports) same_.ports[index(p)] = ports.take(new_.id(p), new_[p].name);
  }

  static std::vector<std::string> parameter_names(const StateInfo& info) {
    std::vector<std::string> names;
    for (const ParameterInfo& parameter : info.parameters) names.push_back(parameter.name);
    return names;
  }

  void match_values(const std::vector<std::string>& names, ValueIndex first, const std::vector<std::string>& before,
                    ValueIndex first_before) {
    Siblings values;
    for (std::uint32_t i = 0; i < before.size(); ++i)
      values.add(old_.ids.values[first_before + i], before[i], first_before + i);
    for (std::uint32_t i = 0; i < names.size(); ++i)
      same_.values[first + i] = values.take(new_.ids.values[first + i], names[i]);
  }

  // By their texts, whatever their ids are: one that says something else is another one (R19). Of equal ones the k-th
  // is the k-th.
  void match_actions(const StateInfo& info, const StateInfo& before) {
    using Texts = std::pair<std::string_view, std::string_view>;
    struct Hash {
      std::size_t operator()(const Texts& texts) const {
        return std::hash<std::string_view>()(texts.first) * 31 + std::hash<std::string_view>()(texts.second);
      }
    };
    std::unordered_map<Texts, std::vector<ActionId>, Hash> actions;  // the last one first
    for (ActionId a = before.actions.high; a-- > before.actions.low;)
      actions[{old_.actions[a].when.text(), old_.actions[a].code.text()}].push_back(a);
    for (const ActionId a : info.actions) {
      const auto equal = actions.find({new_.actions[a].when.text(), new_.actions[a].code.text()});
      if (equal == actions.end() || equal->second.empty()) continue;
      same_.actions[a] = equal->second.back();
      equal->second.pop_back();
    }
  }

  const Program &old_, &new_;
  Correspondence& same_;
};

}  // namespace

Correspondence::Correspondence(const Program& after)
    : states(after.states.size(), kNone),
      barriers(after.barriers.size(), kNone),
      ports(after.ports.size(), kNone),
      actions(after.actions.size(), kNone),
      values(after.initial.size(), kNone) {}

Correspondence::Correspondence(const Program& before, const Program& after) : Correspondence(after) {
  Matcher(before, after, *this).match();
}

Correspondence Correspondence::identity(const Program& program) {
  Correspondence same(program);
  for (auto* numbers : {&same.states, &same.barriers, &same.ports, &same.actions, &same.values})
    std::iota(numbers->begin(), numbers->end(), 0U);
  return same;
}

}  // namespace race::semantics
