// Groups: siblings in a state of their own.
#include <algorithm>
#include <set>

#include "core/edit/builder.h"
#include "core/edit/compound.h"
#include "core/edit/references.h"
#include "core/rcm/deep_history.h"

namespace race::edit {
namespace {

class Group {
 public:
  Group(const Tree& tree, const std::string& parent, Ids members, std::string_view name, std::string_view seed)
      : tree_(tree), parent_(parent), members_(std::move(members)), name_(name), ids_(tree, seed), builder_(tree) {
    for (const std::string& id : members_) names_.insert(name_of(tree, id));
  }

  Expected<Edit> make() {
    const rcm::State& composite = *state_of(tree_, parent_);
    if (composite.oracle) fail(ErrorCode::oracle, "the parent chooses among its children", parent_);
    if (rcm::is_resumed(tree_.document(), parent_))
      fail(ErrorCode::keep, "a deep history goes on with a child of the parent, and would begin the group anew",
           parent_);
    if (composite.keep && composite.keep->deep)
      fail(ErrorCode::keep, "the parent keeps what its children have; the group would begin anew", parent_);
    find_first(composite);
    for (const std::string& id : members_) {
      check_barrier(id);
      check_keep(id);
    }
    export_ports();
    for (const CodeText& text : texts_in_scope(tree_, parent_)) {
      const References references = references_in(text);
      if (!references.is_parsed) {
        fail(ErrorCode::syntax, quote(text.field) + " cannot be parsed", text.id);
      } else {
        is_of_member(text) ? take_parameters(text, references) : take_results(text, references);
      }
    }
    for (const TakenOver& taken : taken_over_texts(tree_, parent_)) check_taken_over(taken);
    if (builder_.failed()) return builder_.take();
    insert();
    lead_to_group(composite);
    for (auto& change : changes_) builder_.add(std::move(change));
    return builder_.take();
  }

 private:
  void fail(ErrorCode code, std::string message, const std::string& path) {
    builder_.fail({code, std::move(message), path});
  }

  bool is_member(const std::string& id) const { return std::ranges::find(members_, id) != members_.end(); }
  bool is_inside(const std::string& name) const { return names_.contains(name); }
  /// Of the parameters of one of the members.
  bool is_of_member(const CodeText& text) const {
    return text.field == "from" && is_member(tree_.find(text.id)->parent);
  }

  /// Calls visit(id, names of its targets) for each port and barrier of a sibling outside.
  template <typename Visit>
  void for_each_outside(Visit visit) const {
    for (const std::string& sibling : tree_.list(parent_, ListName::children)) {
      if (is_member(sibling)) continue;
      for (const std::string& port : tree_.list(sibling, ListName::ports)) {
        const auto& to = std::get<rcm::Port>(tree_.find(port)->content).to;
        if (to) visit(port, std::vector<std::string>{*to});
      }
      if (const auto* barrier = std::get_if<rcm::Barrier>(&tree_.find(sibling)->content)) visit(sibling, barrier->to);
    }
  }

  void find_first(const rcm::State& composite) {
    std::set<std::string> entered;
    const auto enter = [&](const std::string& name) {
      if (is_inside(name)) entered.insert(name);
    };
    if (composite.first) enter(*composite.first);
    for_each_outside([&](const std::string&, const std::vector<std::string>& to) { std::ranges::for_each(to, enter); });
    if (entered.size() > 1) return fail(ErrorCode::first, "the group would be entered at several states", parent_);
    if (entered.empty()) return;
    first_ = *entered.begin();
    if (!state_of(tree_, find_by_name(tree_, parent_, ListName::children, *first_)))
      fail(ErrorCode::first, "the group would be entered at the barrier " + quote(*first_), parent_);
  }

  void check_barrier(const std::string& id) {
    const auto* barrier = std::get_if<rcm::Barrier>(&tree_.find(id)->content);
    if (barrier && !std::ranges::all_of(barrier->to, [&](const auto& to) { return is_inside(to); }))
      fail(ErrorCode::barrier_target, "the barrier " + quote(barrier->name) + " leads outside", id);
  }

  /// What a state keeps (R8), it keeps within one activation of its parent, which would be the group.
  void check_keep(const std::string& id) {
    const rcm::State* state = state_of(tree_, behaviour_of(tree_, id));
    if (state && (state->keep || (state->oracle && state->oracle->kind == rcm::Oracle::Kind::history)))
      fail(ErrorCode::keep, quote(name_of(tree_, id)) + " keeps what it had when it is entered again", id);
  }

  std::string unique(std::set<std::string>& taken, std::string name) {
    const std::string wanted = name;
    for (int number = 2; !taken.insert(name).second; ++number) name = wanted + std::to_string(number);
    return name;
  }

  void export_ports() {
    for (const std::string& id : members_) {
      for (const std::string& at : tree_.list(id, ListName::ports)) {
        const auto& port = std::get<rcm::Port>(tree_.find(at)->content);
        if (!port.to || is_inside(*port.to)) continue;
        exported(name_of(tree_, id), port.name, port.to);
        changes_.push_back(Set{at, "to", std::nullopt, std::nullopt});
      }
    }
  }

  /// The port of the group that fires when that of a member is active.
  std::string exported(const std::string& state, const std::string& port, const std::optional<std::string>& to) {
    const std::string source = "chi." + state + ".port." + port;
    const auto [entry, is_new] = exported_.try_emplace(source);
    if (!is_new) return entry->second;
    entry->second = unique(port_names_, state + "_" + port);
    Dict out{{"name", entry->second}, {"when", source}};
    if (to) out.set("to", *to);
    out.set("meta", Dict{{"id", ids_(source)}});
    ports_.push_back(std::move(out));
    return entry->second;
  }

  /// Whether a port of a member leads to another one: it is not active for long, and cannot be seen outside.
  bool leads_inside(const std::string& state, const std::string& port) const {
    const std::string member = find_by_name(tree_, parent_, ListName::children, state);
    const std::string id = find_by_name(tree_, member, ListName::ports, port);
    if (id.empty()) return false;
    const auto& to = std::get<rcm::Port>(tree_.find(id)->content).to;
    return to && is_inside(*to);
  }

  /// The parameter of the group that has the value of `expression` of the parent.
  std::string parameter(const std::string& wanted, const std::string& expression) {
    const auto [entry, is_new] = parameters_.try_emplace(expression);
    if (is_new) {
      entry->second = unique(parameter_names_, wanted);
      parameter_list_.push_back(
          Dict{{"name", entry->second}, {"from", expression}, {"meta", Dict{{"id", ids_(expression)}}}});
    }
    return entry->second;
  }

  void take_parameters(const CodeText& text, const References& references) {
    std::vector<Replacement> replacements;
    for (const Reference& reference : references.found) {
      const auto& names = reference.names;
      if (names[0] == "par" && names.size() > 1) {
        const std::string own = parameter(names[1], "par." + names[1]);
        if (own != names[1]) replacements.push_back(with_name(text.text, reference, 1, own));
        continue;
      }
      if (names[0] == "chi" && names.size() > 1 && is_inside(names[1])) continue;
      if (names[0] == "chi" && names.size() > 3 && (names[2] == "res" || names[2] == "par")) {
        const std::string own =
            parameter(names[1] + "_" + names[3], "chi." + names[1] + "." + names[2] + "." + names[3]);
        replacements.push_back({{reference.spans[0].begin, reference.spans[3].end}, "par." + own});
        continue;
      }
      return fail(ErrorCode::scope,
                  "a parameter reads " + quote(slice(text.text, reference.whole)) +
                      " of the parent, which the group does not have",
                  text.id);
    }
    change(text, std::move(replacements));
  }

  void take_results(const CodeText& text, const References& references) {
    std::vector<Replacement> replacements;
    for (const Reference& reference : references.found) {
      const auto& names = reference.names;
      if (names[0] != "chi" || names.size() < 2 || !is_inside(names[1])) continue;
      const bool is_port = names.size() > 3 && names[2] == "port" && !leads_inside(names[1], names[3]);
      if (!is_port && (names.size() < 4 || names[2] != "res"))
        return fail(ErrorCode::scope,
                    quote(slice(text.text, reference.whole)) + " is read outside, and a group offers results and exits",
                    text.id);
      replacements.push_back(with_name(text.text, reference, 1, name_));
      replacements.push_back(with_name(
          text.text, reference, 3, is_port ? exported(names[1], names[3], std::nullopt) : result(names[1], names[3])));
    }
    change(text, std::move(replacements));
  }

  /// The result of the group that has the value of a member's.
  std::string result(const std::string& state, const std::string& name) {
    const std::string source = "chi." + state + ".res." + name;
    const auto [entry, is_new] = results_.try_emplace(source);
    if (!is_new) return entry->second;
    entry->second = unique(result_names_, state + "_" + name);
    Dict result{{"name", entry->second}};
    const std::string member = find_by_name(tree_, parent_, ListName::children, state);
    if (const std::string id = find_by_name(tree_, behaviour_of(tree_, member), ListName::results, name); !id.empty()) {
      const Value declared = tree_.write(id);
      for (const char* field : {"initial", "type", "unit", "doc"}) {
        if (const Value* value = declared.find(field)) result.set(field, *value);
      }
    }
    result.set("meta", Dict{{"id", ids_(source)}});
    result_list_.push_back(std::move(result));
    actions_.push_back(Dict{{"when", "available(" + source + ")"},
                            {"do", "res." + entry->second + " = " + source},
                            {"meta", Dict{{"id", ids_("take " + source)}}}});
    return entry->second;
  }

  void check_taken_over(const TakenOver& taken) {
    const References references = references_in(taken.text);
    if (!references.is_parsed)
      return fail(ErrorCode::syntax, quote(taken.text.field) + " cannot be parsed", taken.text.id);
    for (const Reference& reference : references.found) {
      const bool is_of_inside =
          reference.names.size() > 1 && reference.names[0] == "chi" && is_inside(reference.names[1]);
      if (is_member(taken.link) || is_of_inside)
        return fail(ErrorCode::scope,
                    "its parameter " + quote(name_of(tree_, taken.text.id)) + " reads " +
                        quote(slice(taken.text.text, reference.whole)) + " in the library",
                    taken.link);
    }
  }

  void change(const CodeText& text, std::vector<Replacement> replacements) {
    if (replacements.empty()) return;
    changes_.push_back(
        Set{text.id, text.field, std::nullopt, field_with(tree_, text, replaced(text.text, std::move(replacements)))});
  }

  void insert() {
    const std::string own = ids_("group");
    Dict node{{"state", name_}};
    const auto set_list = [&](std::string_view list, List& elements) {
      if (!elements.empty()) node.set(list, std::move(elements));
    };
    set_list("parameters", parameter_list_);
    set_list("results", result_list_);
    set_list("actions", actions_);
    if (first_) node.set("first", *first_);
    set_list("ports", ports_);
    node.set("keep", true);  // what its states had stays to be read when it is entered again, as outside
    node.set("meta", Dict{{"id", own}});
    builder_.add(Insert{{parent_, ListName::children, tree_.before(members_.front())}, std::move(node)});
    std::optional<std::string> after;
    for (const std::string& id : members_) {
      builder_.add(Move{id, {own, ListName::children, after}});
      after = id;
    }
  }

  /// What led to the first state leads to the group.
  void lead_to_group(const rcm::State& composite) {
    if (!first_) return;
    if (composite.first == first_) builder_.set(parent_, "first", Value(name_));
    for_each_outside([&](const std::string& id, std::vector<std::string> to) {
      std::ranges::replace(to, *first_, name_);
      const bool is_port = tree_.find(id)->list == ListName::ports;
      builder_.set(id, "to", is_port ? Value(to.front()) : Value(List(to.begin(), to.end())));
    });
  }

  const Tree& tree_;
  const std::string parent_;
  const Ids members_;
  const std::string name_;
  std::set<std::string> names_;
  NewIds ids_;
  Builder builder_;
  std::optional<std::string> first_;
  std::map<std::string, std::string> parameters_, results_,
      exported_;  // of the group, by the expression that they stand for
  std::set<std::string> parameter_names_, result_names_, port_names_;
  List parameter_list_, result_list_, actions_, ports_;
  std::vector<Operation> changes_;  // of texts and ports that are there already
};

}  // namespace

Expected<Edit> group(const Tree& tree, const Ids& ids, std::string_view name, std::string_view seed) {
  if (ids.empty()) return unexpected(ErrorCode::not_accepted, "a group has at least one state", "ids");
  for (const std::string& id : ids) {
    const Element* element = tree.find(id);
    if (!element) return no_element(id, "ids");
    if (element->list != ListName::children || element->parent != tree.find(ids.front())->parent)
      return unexpected(ErrorCode::not_accepted, "a group is made of children of one state", "ids");
  }
  const std::string& parent = tree.find(ids.front())->parent;
  if (auto fits = check_new_name(tree, parent, ListName::children, name); !fits) return tl::unexpected(fits.error());
  Ids members;
  for (const std::string& child : tree.list(parent, ListName::children)) {
    if (std::ranges::find(ids, child) != ids.end()) members.push_back(child);
  }
  return Group(tree, parent, std::move(members), name, seed).make();
}

}  // namespace race::edit
