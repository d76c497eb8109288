#include "tests/unit/core/execution/naive_carry_over.h"

#include <map>
#include <optional>
#include <regex>
#include <vector>

#include "core/value/json.h"

namespace race::execution {
namespace {

const Value& field(const Value& json, std::string_view key) {
  static const Value none = Value::unknown();
  const Value* found = json.is_dict() ? json.find(key) : nullptr;
  return found ? *found : none;
}
std::string text(const Value& json, std::string_view key) {
  const Value& found = field(json, key);
  return found.is_string() ? found.as_string() : "";
}
const List& items(const Value& json, std::string_view key) {
  static const List none;
  const Value& found = field(json, key);
  return found.is_list() ? found.as_list() : none;
}
std::int64_t number(const Value& json, std::string_view key) {
  const Value& found = field(json, key);
  return found.is_integer() ? found.as_integer() : 0;
}
bool is_true(const Value& json, std::string_view key) { return field(json, key) == Value(true); }
std::string id_of(const Value& element) { return text(field(element, "meta"), "id"); }

/// A state or barrier of a native model.
struct Node {
  const Value* json = nullptr;
  std::string parent;  // its path
  bool barrier = false;
};
using Nodes = std::map<std::string, Node>;  // by path

void collect(const Value& json, const std::string& parent, Nodes& out) {
  const bool barrier = json.find("barrier") != nullptr;
  const std::string path = (parent.empty() ? "" : parent + "/") + text(json, barrier ? "barrier" : "state");
  out[path] = {&json, parent, barrier};
  for (const Value& child : items(json, "children")) collect(child, path, out);
}
Nodes nodes_of(const Value& root) {
  Nodes out;
  collect(root, "", out);
  return out;
}

const Value* with_id(const List& list, const std::string& id) {
  for (const Value& each : list)
    if (id_of(each) == id) return &each;
  return nullptr;
}

/// "A node of M' is one of M if both have the same `meta.id` (the same name, if one has no id), the same kind, and the
/// same node of M as parent".
std::map<std::string, std::string> same_nodes(const Nodes& before, const Nodes& after) {
  std::map<std::string, std::string> by_id;
  for (const auto& [path, node] : before) by_id[id_of(*node.json)] = path;
  std::map<std::string, std::string> same;  // path after the edit -> path before
  for (const auto& [path, node] : after) {  // a parent's path sorts before those of its children
    const auto found = by_id.find(id_of(*node.json));
    if (found == by_id.end()) continue;
    const Node& old = before.at(found->second);
    const bool same_parent =
        node.parent.empty() ? old.parent.empty() : same.contains(node.parent) && same[node.parent] == old.parent;
    if (old.barrier == node.barrier && same_parent) same[path] = found->second;
  }
  return same;
}

/// Code that R19 is about: it contains svc, but not only in `.latest`.
bool commands(const Value& action) {
  static const std::regex latest(R"re(svc(\.\w+|\[[^\]]*\])\.\w+\.latest)re");
  return (std::regex_replace(text(action, "when"), latest, "") + std::regex_replace(text(action, "do"), latest, ""))
             .find("svc") != std::string::npos;
}

std::string code_of(const Value& state) {
  std::string code = text(state, "entry") + "\n" + text(state, "exit");
  for (const Value& action : items(state, "actions")) code += "\n" + text(action, "when") + "\n" + text(action, "do");
  for (const Value& port : items(state, "ports")) code += "\n" + text(port, "when");
  return code;
}

/// Scopes as the function language, checkpoints and models call them.
struct Scope {
  const char *name, *list;
};
constexpr Scope kScopes[] = {{"par", "parameters"}, {"res", "results"}, {"var", "variables"}};

class Naive {
 public:
  explicit Naive(const Carrying& run)
      : run_(run), before_(nodes_of(run.before)), after_(nodes_of(run.after)), same_(same_nodes(before_, after_)) {
    for (const Value& barrier : items(run.checkpoint, "active_barriers")) active_barriers_.insert(barrier.as_string());
  }

  std::set<std::string> lost() const {
    std::set<std::string> kept, out;
    for (const auto& [path, old] : same_) kept.insert(old);
    for (const auto& [path, node] : before_)
      if (was_active(path, node) && !kept.contains(path) && (node.parent.empty() || kept.contains(node.parent)))
        out.insert(path);
    return out;
  }

  std::set<std::string> unresolved() const {
    std::set<std::string> out;
    for (const auto& [path, node] : after_)
      if (is_active(path))
        for (const Value& parameter : items(*node.json, "parameters")) {
          const auto value = parameter_value(path, text(parameter, "name"));
          if (value && value->is_unknown()) out.insert(path + "." + text(parameter, "name"));
        }
    return out;
  }

  std::string difference(const Value& carried) {
    compare_head(carried);
    compare_calls(carried);
    for (const auto& [path, node] : after_) {
      if (node.barrier)
        compare_barrier(path, carried);
      else
        compare_state(path, node, field(field(carried, "states"), path));
    }
    for (const auto& [path, state] : dict(field(carried, "states")))
      if (!after_.contains(path.as_string())) say(path.as_string(), "is not in the model");
    return difference_;
  }

 private:
  static const Dict& dict(const Value& json) {
    static const Dict none;
    return json.is_dict() ? json.as_dict() : none;
  }
  void say(const std::string& where, const std::string& what) {
    if (difference_.empty()) difference_ = where + ": " + what;
  }
  void expect(const std::string& where, const Value& expected, const Value& found) {
    if (!(expected == found)) say(where, "expected " + shown(expected) + ", found " + shown(found));
  }
  static std::string shown(const Value& value) { return value.is_unknown() ? "nothing" : to_json(value); }

  const Value& old_state(const std::string& old_path) const {
    return field(field(run_.checkpoint, "states"), old_path);
  }
  bool was_active(const std::string& path, const Node& node) const {
    return node.barrier ? active_barriers_.contains(path) : is_true(old_state(path), "active");
  }
  std::optional<std::string> old_path(const std::string& path) const {
    const auto same = same_.find(path);
    return same == same_.end() ? std::nullopt : std::optional(same->second);
  }
  bool is_active(const std::string& path) const {
    const auto old = old_path(path);
    return old && !after_.at(path).barrier && is_true(old_state(*old), "active");
  }

  // ---- Σ

  void compare_head(const Value& carried) {
    for (const char* key : {"position", "epoch"})
      expect(key, Value(number(run_.checkpoint, key) + 1), field(carried, key));
    for (const char* key : {"call_count", "services_called"})
      expect(key, field(run_.checkpoint, key), field(carried, key));
    expect("occurrence", Value::unknown(), field(carried, "occurrence"));
    const std::string code = to_json(run_.after);
    for (const Value& event : items(carried, "events"))
      if (!contains(run_.checkpoint, "events", event)) say("events", to_json(event) + " was not there");
    for (const Value& event : items(run_.checkpoint, "events"))
      if (code.find("svc." + text(event, "service") + "." + text(event, "event")) != std::string::npos &&
          !contains(carried, "events", event))
        say("events", to_json(event) + " is gone");
  }
  static bool contains(const Value& json, const char* key, const Value& item) {
    const List& all = items(json, key);
    return std::find(all.begin(), all.end(), item) != all.end();
  }

  // "Latched responses, open calls and call numbers are kept by (caller, S, op) [...]; calls of removed callers are
  // dropped, and what is about an event that M' does not name or an operation that it neither names nor has declared."
  void compare_calls(const Value& carried) {
    std::map<std::string, std::string> after;
    for (const auto& [path, old] : same_) after[old] = path;
    std::size_t kept = 0;
    for (const Value& call : items(run_.checkpoint, "calls")) {
      const auto caller = after.find(text(call, "caller"));
      if (caller == after.end()) continue;
      Dict expected = call.as_dict();
      expected.set("caller", caller->second);
      // Of services that nobody declares, a program knows what its code names.
      const bool is_declared = text(call, "service") == "t" || text(call, "service") == "u";
      const bool is_kept = contains(carried, "calls", Value(expected));
      if (is_declared && !is_kept) say("calls", to_json(Value(expected)) + " is gone");
      kept += is_kept ? 1 : 0;
    }
    if (items(carried, "calls").size() != kept) say("calls", "there are others: " + to_json(field(carried, "calls")));
  }

  // ---- Δ

  void compare_state(const std::string& path, const Node& node, const Value& carried) {
    const auto old = old_path(path);
    const Value& then = old ? old_state(*old) : Value::unknown();
    for (const char* key : {"active", "activations", "life", "activated_in", "activated_at", "calls_before"})
      expect(path + "/" + key, field(then, key), field(carried, key));
    compare_left_through(path, node, then, carried);
    for (const Scope& scope : kScopes) compare_values(path, node, scope, field(carried, scope.list));
    compare_actions(path, node, then, carried);
    for (const Value& port : items(*node.json, "ports"))
      compare_port(path, node, port, field(field(carried, "ports"), text(port, "name")));
  }

  void compare_left_through(const std::string& path, const Node& node, const Value& then, const Value& carried) {
    Value through = Value::unknown(), during = Value::unknown();
    const Value& keep = field(*node.json, "keep");
    if (const auto old = old_path(path); old && !keep.is_unknown() && !node.parent.empty())
      for (const Value& port : items(*before_.at(*old).json, "ports"))
        if (text(port, "name") == text(then, "left_through"))
          if (const Value* now = with_id(items(*node.json, "ports"), id_of(port))) {
            through = field(*now, "name");
            during = field(then, "left_during");
          }
    const bool with_parent = field(then, "left_through").is_unknown();
    if (with_parent && is_true(keep, "deep") && !node.parent.empty()) during = field(then, "left_during");
    expect(path + "/left_through", through, field(carried, "left_through"));
    expect(path + "/left_during", during, field(carried, "left_during"));
  }

  /// Those of M' that are one of M have the value that they had; others, and those without one, the initial one.
  /// Nothing: it depends on more than this.
  std::optional<Value> value_of(const std::string& path, const Scope& scope, const std::string& name) const {
    if (std::string(scope.name) == "par") return parameter_value(path, name);
    const Value* declared = named(items(*after_.at(path).json, scope.list), name);
    if (!declared) return std::nullopt;
    Value value = old_value(path, scope, *declared);
    return value.is_unknown() ? field(*declared, "initial") : value;
  }
  std::optional<Value> parameter_value(const std::string& path, const std::string& name) const {
    const Node& node = after_.at(path);
    const Value* declared = named(items(*node.json, "parameters"), name);
    if (!declared) return std::nullopt;
    if (Value value = old_value(path, kScopes[0], *declared); !value.is_unknown()) return value;
    if (!is_active(path)) return Value::unknown();
    if (declared->find("value")) return field(*declared, "value");
    const std::string from = text(*declared, "from");
    if (from.empty() || node.parent.empty()) return Value::unknown();
    static const std::regex simple(R"((par|res|var)\.(\w+))");
    std::smatch match;
    if (!std::regex_match(from, match, simple)) return std::nullopt;
    for (const Scope& scope : kScopes)
      if (match[1] == scope.name) return value_of(node.parent, scope, match[2]);
    return std::nullopt;
  }
  static const Value* named(const List& list, const std::string& name) {
    for (const Value& each : list)
      if (text(each, "name") == name) return &each;
    return nullptr;
  }
  // By id; one that code uses without declaring it has none, so that its name counts.
  Value old_value(const std::string& path, const Scope& scope, const Value& declared) const {
    const auto old = old_path(path);
    if (!old) return Value::unknown();
    const List& list = items(*before_.at(*old).json, scope.list);
    const Value& values = field(old_state(*old), scope.list);
    const Value* was = with_id(list, id_of(declared));
    if (!was && named(list, text(declared, "name"))) return Value::unknown();
    const Value& value = field(values, text(was ? *was : declared, "name"));
    return value.is_unknown() && was ? field(*was, "initial") : value;
  }

  void compare_values(const std::string& path, const Node& node, const Scope& scope, const Value& carried) {
    for (const Value& declared : items(*node.json, scope.list)) {
      const std::string name = text(declared, "name"), where = path + "/" + scope.name + "." + name;
      const auto value = value_of(path, scope, name);
      if (!value) continue;
      const bool is_initial = std::string(scope.name) != "par" && *value == field(declared, "initial");
      expect(where, is_initial ? Value::unknown() : *value, field(carried, name));
    }
    compare_undeclared(path, node, scope, carried);
  }
  void compare_undeclared(const std::string& path, const Node& node, const Scope& scope, const Value& carried) {
    const auto old = old_path(path);
    const Value& then = old ? field(old_state(*old), scope.list) : Value::unknown();
    for (const auto& [name, value] : dict(carried))
      if (!named(items(*node.json, scope.list), name.as_string())) {
        const Value* was = old ? named(items(*before_.at(*old).json, scope.list), name.as_string()) : nullptr;
        const Value& then_value = field(then, name.as_string());
        const Value& expected = then_value.is_unknown() && was ? field(*was, "initial") : then_value;
        expect(path + "/" + name.as_string(), expected, value);
      }
    if (!old) return;
    for (const auto& [name, value] : dict(then))
      if (!named(items(*before_.at(*old).json, scope.list), name.as_string()) &&
          code_of(*node.json).find(std::string(scope.name) + "." + name.as_string()) != std::string::npos &&
          !named(items(*node.json, scope.list), name.as_string()))
        expect(path + "/" + name.as_string(), value, field(carried, name.as_string()));
  }

  // "An action is the same if state, `when` and `do` are the same (k-th equal one to k-th); a new or changed action
  // that contains `svc` as R19 says starts, in an active state, as served".
  void compare_actions(const std::string& path, const Node& node, const Value& then, const Value& carried) {
    const auto old = old_path(path);
    const auto texts = [](const Value& action) { return text(action, "when") + "\n->" + text(action, "do"); };
    std::map<std::string, std::vector<std::int64_t>> equal;
    if (old)
      for (const Value& action : items(*before_.at(*old).json, "actions"))
        equal[texts(action)].push_back(
            static_cast<std::int64_t>(&action - &items(*before_.at(*old).json, "actions")[0]));
    std::map<std::string, std::size_t> taken;
    std::int64_t at = -1;
    for (const Value& action : items(*node.json, "actions")) {
      const std::string where = path + "/actions/" + std::to_string(++at);
      const Value& found = numbered(carried, at);
      const std::size_t k = taken[texts(action)]++;
      if (k < equal[texts(action)].size()) {
        const Value& was = numbered(then, equal[texts(action)][k]);
        expect(where + "/executed", field(was, "executed"), field(found, "executed"));
        expect(where + "/served", field(was, "served"), field(found, "served"));
      } else if (commands(action) && is_active(path)) {
        if (number(found, "served") <= number(run_.checkpoint, "tick")) say(where, "is new and not served");
        expect(where + "/executed", Value::unknown(), field(found, "executed"));
      } else {
        expect(where, Value::unknown(), found);
      }
    }
  }
  static const Value& numbered(const Value& state, std::int64_t at) {
    static const Value none = Value::unknown();
    for (const Value& action : items(state, "actions"))
      if (number(action, "action") == at) return action;
    return none;
  }

  const Value& old_port(const std::string& path, const Value& port, const Value** json) const {
    static const Value none = Value::unknown();
    const auto old = old_path(path);
    *json = old ? with_id(items(*before_.at(*old).json, "ports"), id_of(port)) : nullptr;
    return *json ? field(field(old_state(*old), "ports"), text(**json, "name")) : none;
  }

  void compare_port(const std::string& path, const Node& node, const Value& port, const Value& carried) {
    const Value* json = nullptr;
    const Value& then = old_port(path, port, &json);
    const std::string where = path + "." + text(port, "name");
    expect(where + "/active", field(then, "active"), field(carried, "active"));
    expect(where + "/triggered", Value::unknown(), field(carried, "triggered"));
    expect(where + "/arrived", has_arrived(path, node, port) ? Value(true) : Value::unknown(),
           field(carried, "arrived"));
  }

  // "activated(b) := activated(b) ∩ in'(b)".
  bool has_arrived(const std::string& path, const Node& node, const Value& port) const {
    const Value* json = nullptr;
    if (!is_true(old_port(path, port, &json), "arrived")) return false;
    const std::string to = node.parent + "/" + text(port, "to"),
                      to_before = before_.at(*old_path(path)).parent + "/" + text(*json, "to");
    return !text(port, "to").empty() && old_path(to) == to_before;
  }

  // "if that is in'(b) and not ∅, b becomes active".
  void compare_barrier(const std::string& path, const Value& carried) {
    const Node& barrier = after_.at(path);
    std::size_t in = 0, arrived = 0;
    for (const auto& [sibling, node] : after_)
      if (!node.barrier && node.parent == barrier.parent)
        for (const Value& port : items(*node.json, "ports"))
          if (text(port, "to") == text(*barrier.json, "barrier")) {
            ++in;
            arrived += has_arrived(sibling, node, port) ? 1 : 0;
          }
    const bool was = old_path(path) && active_barriers_.contains(*old_path(path));
    const bool expected = was || (in > 0 && in == arrived);
    if (contains(carried, "active_barriers", Value(path)) != expected) say(path, expected ? "is closed" : "is open");
  }

  const Carrying& run_;
  const Nodes before_, after_;
  const std::map<std::string, std::string> same_;
  std::set<std::string> active_barriers_;
  std::string difference_;
};

}  // namespace

std::set<std::string> lost_paths(const Carrying& run) { return Naive(run).lost(); }
std::set<std::string> unresolved_parameters(const Carrying& run) { return Naive(run).unresolved(); }
std::string carry_over_difference(const Carrying& run, const Value& carried) { return Naive(run).difference(carried); }

}  // namespace race::execution
