// The way back from a group.
#include <algorithm>
#include <set>

#include "core/edit/builder.h"
#include "core/edit/compound.h"
#include "core/edit/references.h"
#include "core/language/values/printing.h"
#include "core/rcm/deep_history.h"

namespace race::edit {
namespace {

/// The reference that a text is, and nothing else.
std::optional<Reference> only_reference(const CodeText& text) {
  const References references = references_in(text);
  if (!references.is_parsed || references.found.size() != 1) return std::nullopt;
  const language::Span whole = references.found[0].whole;
  if (whole.begin != 0 || whole.end != text.text.size()) return std::nullopt;
  return references.found[0];
}

class Ungroup {
 public:
  Ungroup(const Tree& tree, std::string_view id)
      : tree_(tree), id_(id), parent_(tree.find(id)->parent), state_(*state_of(tree, id)), builder_(tree) {}

  Expected<Edit> make() {
    check_state();
    check_names();
    for (const std::string& action : tree_.list(id_, ListName::actions)) read_action(action);
    for (const std::string& result : tree_.list(id_, ListName::results)) {
      if (!sources_.contains(name_of(tree_, result))) fail("nothing but a group takes over its results", result);
    }
    for (const std::string& port : tree_.list(id_, ListName::ports)) give_back_port(port);
    give_back_texts();
    lead_to_first();
    move_out();
    return builder_.take();
  }

 private:
  void fail(std::string message, const std::string& path) {
    builder_.fail({ErrorCode::not_accepted, std::move(message), path});
  }

  void check_state() {
    if (state_.link || state_.oracle || state_.entry || state_.exit ||
        (state_.keep && (!state_.keep->any || state_.keep->deep)) || !tree_.list(id_, ListName::variables).empty())
      fail("a state with a link, an oracle, `entry`, `exit`, `keep` for some ports or variables is more than a group",
           id_);
    if (state_of(tree_, parent_)->oracle) fail("the parent chooses among its children", parent_);
    if (rcm::is_resumed(tree_.document(), parent_))
      fail("a deep history goes on with a child of the parent, but begins the group anew", id_);
  }

  void check_names() {
    for (const std::string& child : tree_.list(id_, ListName::children)) {
      const std::string& name = name_of(tree_, child);
      const std::string other = find_by_name(tree_, parent_, ListName::children, name);
      if (!other.empty()) builder_.fail({ErrorCode::duplicate, "there is a " + quote(name) + " outside", child});
    }
  }

  /// when available(chi.A.res.x) do res.y = chi.A.res.x
  void read_action(const std::string& id) {
    const auto& action = std::get<rcm::Action>(tree_.find(id)->content);
    const References references = references_in({id, "do", action.code, language::CodeKind::function});
    if (references.is_parsed && references.found.size() == 2) {
      const Reference& target = references.found[0];
      const Reference& source = references.found[1];
      const std::string read(slice(action.code, source.whole));
      const bool is_take_over = target.names.size() == 2 && target.names[0] == "res" && source.names.size() == 4 &&
                                source.names[0] == "chi" && source.names[2] == "res" &&
                                action.code == "res." + target.names[1] + " = " + read &&
                                action.when == "available(" + read + ")";
      if (is_take_over && sources_.emplace(target.names[1], source.names).second) return;
    }
    fail("a group has no actions but those that take over results", id);
  }

  /// A port of the group fires with that of a child, which leads nowhere.
  void give_back_port(const std::string& id) {
    const auto& port = std::get<rcm::Port>(tree_.find(id)->content);
    const auto reference = only_reference({id, "when", port.when.value_or(""), language::CodeKind::condition});
    const auto refused = [&] { fail("a port of a group fires with one port of a child, which leads nowhere", id); };
    if (!reference || reference->names.size() != 4 || reference->names[0] != "chi" || reference->names[2] != "port")
      return refused();
    const std::string child = find_by_name(tree_, id_, ListName::children, reference->names[1]);
    const rcm::State* state = state_of(tree_, child);
    if (!state || !given_back_.insert(*port.when).second) return refused();
    ports_.emplace(port.name, reference->names);
    const std::string inner = find_by_name(tree_, child, ListName::ports, reference->names[3]);
    if (inner.empty()) return state->link && !port.to ? static_cast<void>(0) : refused();
    if (std::get<rcm::Port>(tree_.find(inner)->content).to) return refused();
    if (port.to == state_.name) return enter(inner, "to", Value(state_.first.value_or("")));
    if (port.to) builder_.set(inner, "to", Value(*port.to));
  }

  /// What stands for a parameter of the group.
  std::optional<std::string> expression_of(const std::string& name) {
    const std::string id = find_by_name(tree_, id_, ListName::parameters, name);
    if (id.empty()) return std::nullopt;
    const auto& parameter = std::get<rcm::Parameter>(tree_.find(id)->content);
    if (!parameter.from && !parameter.value) return std::nullopt;
    const std::string text = parameter.from ? *parameter.from : language::repr(*parameter.value);
    const bool is_simple = only_reference({id, "from", text, language::CodeKind::expression}).has_value() ||
                           (!parameter.from && !text.starts_with('-'));
    return is_simple ? text : "(" + text + ")";
  }

  void give_back_texts() {
    for (const CodeText& text : texts_in_scope(tree_, id_)) {
      if (text.field == "from") give_back(text, [&](const Reference& r) { return parameter_of_child(r); });
    }
    for (const CodeText& text : texts_in_scope(tree_, parent_)) {
      if (tree_.find(text.id)->parent != id_)
        give_back(text, [&](const Reference& r) { return result_outside(text, r); });
    }
    for (const TakenOver& taken : taken_over_texts(tree_, id_))
      keep_taken_over(taken, [&](const Reference& r) { return parameter_of_child(r); });
    for (const TakenOver& taken : taken_over_texts(tree_, parent_))
      keep_taken_over(taken, [&](const Reference& r) { return result_outside(taken.text, r); });
  }

  using Replacements = std::optional<std::vector<Replacement>>;

  template <typename Replace>
  void give_back(const CodeText& text, Replace replace) {
    const References references = references_in(text);
    if (!references.is_parsed)
      return builder_.fail({ErrorCode::syntax, quote(text.field) + " cannot be parsed", text.id});
    std::vector<Replacement> all;
    for (const Reference& reference : references.found) {
      const Replacements replacements = replace(reference);
      if (!replacements)
        return fail(quote(slice(text.text, reference.whole)) + " has no meaning without the group", text.id);
      all.insert(all.end(), replacements->begin(), replacements->end());
    }
    if (!all.empty()) builder_.set(text.id, text.field, field_with(tree_, text, replaced(text.text, std::move(all))));
  }

  /// A text that must mean the same without the group, as it is.
  template <typename Replace>
  void keep_taken_over(const TakenOver& taken, Replace replace) {
    const References references = references_in(taken.text);
    if (!references.is_parsed)
      return builder_.fail({ErrorCode::syntax, quote(taken.text.field) + " cannot be parsed", taken.text.id});
    for (const Reference& reference : references.found) {
      const Replacements replacements = replace(reference);
      if (replacements && replacements->empty()) continue;
      return builder_.fail({ErrorCode::scope,
                            "its parameter " + quote(name_of(tree_, taken.text.id)) + " reads " +
                                quote(slice(taken.text.text, reference.whole)) + " in the library",
                            taken.link});
    }
  }

  /// Its scope was the group and becomes the parent.
  Replacements parameter_of_child(const Reference& reference) {
    if (reference.names[0] == "chi") return Replacements(std::in_place);
    if (reference.names[0] != "par" || reference.names.size() < 2 || reference.is_literal[1]) return std::nullopt;
    const auto expression = expression_of(reference.names[1]);
    if (!expression) return std::nullopt;
    return std::vector<Replacement>{{{reference.spans[0].begin, reference.spans[1].end}, *expression}};
  }

  Replacements result_outside(const CodeText& text, const Reference& reference) {
    const auto& names = reference.names;
    if (names[0] != "chi" || names.size() < 2 || names[1] != state_.name) return Replacements(std::in_place);
    if (names.size() < 4) return std::nullopt;
    const Sources& sources = names[2] == "port" ? ports_ : sources_;
    const auto source = names[2] == "port" || names[2] == "res" ? sources.find(names[3]) : sources.end();
    if (source == sources.end()) return std::nullopt;
    return std::vector<Replacement>{with_name(text.text, reference, 1, source->second[1]),
                                    with_name(text.text, reference, 3, source->second[3])};
  }

  /// What led to the group leads to its first state.
  void lead_to_first() {
    const std::string first = state_.first.value_or("");
    if (state_of(tree_, parent_)->first == state_.name) enter(parent_, "first", Value(first));
    for (const std::string& sibling : tree_.list(parent_, ListName::children)) {
      if (sibling == id_) continue;
      for (const std::string& port : tree_.list(sibling, ListName::ports)) {
        if (std::get<rcm::Port>(tree_.find(port)->content).to == state_.name) enter(port, "to", Value(first));
      }
      const auto* barrier = std::get_if<rcm::Barrier>(&tree_.find(sibling)->content);
      if (!barrier || std::ranges::find(barrier->to, state_.name) == barrier->to.end()) continue;
      std::vector<std::string> to = barrier->to;
      std::ranges::replace(to, state_.name, first);
      enter(sibling, "to", Value(List(to.begin(), to.end())));
    }
  }

  void enter(const std::string& id, std::string_view field, Value to) {
    const std::string first = state_.first ? find_by_name(tree_, id_, ListName::children, *state_.first) : "";
    if (!state_of(tree_, first)) return fail("it is entered, but its `first` is no state", id_);
    builder_.set(id, field, std::move(to));
  }

  void move_out() {
    std::string after = id_;
    for (const std::string& child : tree_.list(id_, ListName::children)) {
      builder_.add(Move{child, {parent_, ListName::children, after}});
      after = child;
    }
    builder_.add(Remove{id_});
  }

  const Tree& tree_;
  const std::string id_, parent_;
  const rcm::State& state_;
  Builder builder_;
  using Sources = std::map<std::string, std::vector<std::string>>;
  Sources sources_;                   // result of the group -> chi, child, res, result
  Sources ports_;                     // port of the group -> chi, child, port, port
  std::set<std::string> given_back_;  // ports of children
};

}  // namespace

Expected<Edit> ungroup(const Tree& tree, std::string_view id) {
  const Element* element = tree.find(id);
  if (!element) return no_element(id, "id");
  if (element->list != ListName::children || !state_of(tree, id))
    return unexpected(ErrorCode::not_accepted, "what is ungrouped is a state inside of another", "id");
  return Ungroup(tree, id).make();
}

}  // namespace race::edit
