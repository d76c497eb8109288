#include "core/rcm/library.h"

#include <algorithm>

#include "core/rcm/ids.h"

namespace race::rcm {
namespace {

void collect_links(const State& state, std::vector<std::string>& out) {
  if (state.link) out.push_back(*state.link);
  for (const Node& child : state.children) {
    if (const auto* inner = std::get_if<State>(&child)) collect_links(*inner, out);
  }
}

/// The depth-first search of Library::cycles, without recursion: links can form long chains.
class CycleSearch {
 public:
  explicit CycleSearch(std::vector<std::vector<std::size_t>> links)
      : links_(std::move(links)), marks_(links_.size(), Mark::fresh) {}

  std::vector<std::vector<std::size_t>> run() {
    for (std::size_t i = 0; i < links_.size(); ++i) {
      if (marks_[i] == Mark::fresh) visit_from(i);
    }
    return std::move(cycles_);
  }

 private:
  enum class Mark { fresh, on_way, done };
  struct Step {
    std::size_t state, next = 0;  // `next`: the link to follow
  };

  void visit_from(std::size_t start) {
    std::vector<Step> way{{start}};
    marks_[start] = Mark::on_way;
    while (!way.empty()) {
      Step& step = way.back();
      if (step.next == links_[step.state].size()) {
        marks_[step.state] = Mark::done;
        way.pop_back();
        continue;
      }
      const std::size_t target = links_[step.state][step.next++];
      if (marks_[target] == Mark::on_way) record(way, target);
      if (marks_[target] != Mark::fresh) continue;
      marks_[target] = Mark::on_way;
      way.push_back({target});
    }
  }

  void record(const std::vector<Step>& way, std::size_t target) {
    const auto start = std::find_if(way.begin(), way.end(), [&](const Step& s) { return s.state == target; });
    std::vector<std::size_t> cycle;
    for (auto step = start; step != way.end(); ++step) cycle.push_back(step->state);
    std::rotate(cycle.begin(), std::min_element(cycle.begin(), cycle.end()), cycle.end());
    cycles_.push_back(std::move(cycle));
  }

  std::vector<std::vector<std::size_t>> links_;
  std::vector<Mark> marks_;
  std::vector<std::vector<std::size_t>> cycles_;
};

}  // namespace

Library::Library(const Document& document) : document_(document), behaviours_(document.library.size(), nullptr) {
  for (std::size_t i = 0; i < document.library.size(); ++i) index_.emplace(document.library[i].name, i);
  std::vector<bool> known(document.library.size());
  for (std::size_t i = 0; i < document.library.size(); ++i) resolve(i, known);
  for (const State* behaviour : behaviours_) {
    if (!behaviour || interfaces_.contains(behaviour)) continue;
    Interface& interface = interfaces_[behaviour];
    for (const Parameter& parameter : behaviour->parameters) interface.parameters.insert(parameter.name);
    for (const Port& port : behaviour->ports) interface.ports.insert(port.name);
  }
}

/// Finds the behaviour of a state and of all states in its chain of links; `known` marks those already found.
void Library::resolve(std::size_t start, std::vector<bool>& known) {
  std::vector<std::size_t> way;
  const State* behaviour = nullptr;
  for (std::size_t at = start;;) {
    if (known[at]) {
      behaviour = behaviours_[at];
      break;
    }
    known[at] = true;  // ends a cycle with nullptr
    way.push_back(at);
    const State& state = document_.library[at];
    if (!state.link) behaviour = &state;
    const auto next = state.link ? index_.find(*state.link) : index_.end();
    if (next == index_.end()) break;
    at = next->second;
  }
  for (const std::size_t i : way) behaviours_[i] = behaviour;
}

const State* Library::find(std::string_view name) const {
  const auto found = index_.find(name);
  return found == index_.end() ? nullptr : &document_.library[found->second];
}

const State* Library::behaviour(const State& state) const {
  if (!state.link) return &state;
  const auto found = index_.find(*state.link);
  return found == index_.end() ? nullptr : behaviours_[found->second];
}

const Library::Interface* Library::interface(std::string_view name) const {
  const auto found = index_.find(name);
  const State* behaviour = found == index_.end() ? nullptr : behaviours_[found->second];
  return behaviour ? &interfaces_.at(behaviour) : nullptr;
}

std::vector<Parameter> Library::parameters(const State& state) const {
  std::vector<const State*> links;
  const State* at = &state;
  for (; at->link; at = find(*at->link)) links.push_back(at);
  std::vector<Parameter> out = at->parameters;
  std::map<std::string_view, Parameter*> by_name;
  for (Parameter& parameter : out) by_name.emplace(parameter.name, &parameter);
  for (auto link = links.rbegin(); link != links.rend(); ++link) {
    for (const Parameter& own : (*link)->parameters) {
      if (const auto linked = by_name.find(own.name); linked != by_name.end()) override_parameter(*linked->second, own);
    }
  }
  return out;
}

std::vector<std::vector<std::string>> Library::cycles() const {
  std::vector<std::vector<std::size_t>> links(document_.library.size());
  for (std::size_t i = 0; i < links.size(); ++i) {
    std::vector<std::string> names;
    collect_links(document_.library[i], names);
    for (const std::string& name : names) {
      if (const auto found = index_.find(name); found != index_.end()) links[i].push_back(found->second);
    }
  }
  std::vector<std::vector<std::string>> out;
  for (const auto& cycle : CycleSearch(std::move(links)).run()) {
    out.emplace_back();
    for (const std::size_t i : cycle) out.back().push_back(document_.library[i].name);
  }
  return out;
}

Meta merged_meta(const Meta& linked, const Meta& own) {
  Meta out{own.id.empty() ? linked.id : own.id, linked.rest};
  if (linked.rest.is_dict() && own.rest.is_dict()) {
    for (const auto& [key, value] : own.rest.as_dict()) out.rest.mutable_dict().set(key, value);
  } else if (!own.rest.is_null()) {
    out.rest = own.rest;
  }
  wrap_rest(out);
  return out;
}

void override_parameter(Parameter& linked, const Parameter& own) {
  if (own.value || own.from) {
    linked.value = own.value;
    linked.from = own.from;
  }
  if (!own.type.is_null()) linked.type = own.type;
  if (!own.unit.empty()) linked.unit = own.unit;
  if (!own.doc.empty()) linked.doc = own.doc;
  linked.meta = merged_meta(linked.meta, own.meta);
}

}  // namespace race::rcm
