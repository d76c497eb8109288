#include "core/semantics/derivation_text.h"

#include <algorithm>
#include <string_view>

#include "core/value/json.h"

namespace race::semantics {
namespace {

bool is_plain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
         std::string_view("_./").find(c) != std::string_view::npos;
}

// A name, path or address as it is; any other text as JSON.
std::string word(const Value& value) {
  const bool plain =
      value.is_string() && !value.as_string().empty() && std::ranges::all_of(value.as_string(), is_plain);
  return plain ? value.as_string() : to_json(value);
}

const List& items(const Value& value, std::string_view key) {
  static const List kEmpty;
  const Value* found = value.find(key);
  return found && found->is_list() ? found->as_list() : kEmpty;
}

const Dict& entries(const Value& value, std::string_view key) {
  static const Dict kEmpty;
  const Value* found = value.find(key);
  return found && found->is_dict() ? found->as_dict() : kEmpty;
}

std::string joined(const List& words, std::string_view separator) {
  std::string text;
  for (const Value& item : words) text += (text.empty() ? "" : std::string(separator)) + word(item);
  return text;
}

// service.operation(1, key=2)
std::string call_text(const Value& call) {
  std::string text;
  for (const char* key : {"service", "operation"})
    if (const Value* name = call.find(key)) text += (text.empty() ? "" : ".") + word(*name);
  std::string arguments;
  const auto add = [&](const std::string& argument) { arguments += (arguments.empty() ? "" : ", ") + argument; };
  for (const Value& argument : items(call, "args")) add(to_json(argument));
  for (const auto& [key, argument] : entries(call, "kwargs")) add(word(key) + "=" + to_json(argument));
  return text + "(" + arguments + ")";
}

// Root/A par.x
std::string obstacle_text(const Value& obstacle) {
  std::string text;
  if (const Value* path = obstacle.find("path")) text += word(*path);
  if (const Value* parameter = obstacle.find("parameter")) text += " par." + word(*parameter);
  return text;
}

class Transcript {
 public:
  // `number` and `before` go on.
  std::string write_steps(const Value& document, std::size_t& number, Value& before) {
    for (const Value& step : items(document, "steps")) {
      line(0, "step " + std::to_string(number++));
      write_step(step, before);
      if (const Value* state = step.find("state")) before = *state;
    }
    return std::move(text_);
  }

  std::string write_end(const Value& document) {
    write_status(document);
    return std::move(text_);
  }

 private:
  void line(std::size_t level, std::string_view content) {
    text_.append(2 * level, ' ').append(content).push_back('\n');
  }

  void write_step(const Value& step, const Value& before) {
    std::size_t number = 0;
    for (const Value& tree : items(step, "micro")) {
      line(1, "micro " + std::to_string(++number));
      write_node(tree, 2);
    }
    for (const Value& obstacle : items(step, "waits")) line(1, "the edit waits for " + obstacle_text(obstacle));
    for (const Value& call : items(step, "calls")) line(1, "call " + call_text(call));
    if (const Value* state = step.find("state")) write_state(*state, before);
  }

  void write_node(const Value& node, std::size_t level) {
    line(level, node_text(node));
    for (const Value& premise : items(node, "premises")) write_node(premise, level + 1);
  }

  static std::string node_text(const Value& node) {
    std::string text;
    const auto add = [&](std::string_view before, const char* key) {
      if (const Value* value = node.find(key)) text += std::string(before) + word(*value);
    };
    add("", "rule");
    add(" ", "equation");
    add(" at ", "at");
    add(", port ", "port");
    add(", of ", "of");  // entry, exit, or action with its number
    add(node.find("of") ? " " : ", action ", "action");
    add(", parameter ", "parameter");
    if (node.find("operation")) text += ", call " + call_text(node);
    if (const Value* value = node.find("value")) text += " = " + to_json(*value);
    if (const List& required = items(node, "requires"); !required.empty())
      text += " requires " + joined(required, ", ");
    if (const Value* refinement = node.find("refinement")) text += " (" + word(*refinement) + ")";
    return text;
  }

  void write_state(const Value& state, const Value& before) {
    const List& active = items(state, "active");
    line(1, "active " + (active.empty() ? "(none)" : joined(active, " ")));
    if (const List& ports = items(state, "ports"); !ports.empty()) line(1, "ports " + joined(ports, " "));
    for (const auto& [barrier, ports] : entries(state, "activated"))
      line(1, "activated " + word(barrier) + " by " + joined(ports.is_list() ? ports.as_list() : List(), " "));
    write_changes(state, before, "parameters", "par");
    write_changes(state, before, "results", "res");
    write_changes(state, before, "variables", "var");
  }

  // What is set otherwise than before, and what is no longer set.
  void write_changes(const Value& state, const Value& before, const char* key, const std::string& scope) {
    const Dict& now = entries(state, key);
    const Dict& then = entries(before, key);
    const auto name = [&](const Value& path, const Value& of) { return word(path) + " " + scope + "." + word(of); };
    for (const auto& [path, values] : now)
      for (const auto& [of, value] : dict_of(&values))
        if (const Value* old = dict_of(then.find(path)).find(of); !old || *old != value)
          line(1, "set " + name(path, of) + " = " + to_json(value));
    for (const auto& [path, values] : then)
      for (const auto& [of, value] : dict_of(&values))
        if (!dict_of(now.find(path)).find(of)) line(1, "unset " + name(path, of));
  }

  static const Dict& dict_of(const Value* value) {
    static const Dict kEmpty;
    return value && value->is_dict() ? value->as_dict() : kEmpty;
  }

  void write_status(const Value& document) {
    const Value* status = document.find("status");
    if (!status) return;
    std::string text = word(*status);
    if (const Value* outcome = document.find("outcome")) text += ": " + word(*outcome);
    if (const Value* fault = document.find("fault")) {
      const auto add = [&](std::string_view before, const char* key) {
        if (const Value* value = fault->find(key)) text += std::string(before) + word(*value);
      };
      add(": ", "kind");
      add(" at ", "at");
      add(": ", "message");
    }
    line(0, text);
  }

  std::string text_;
};

}  // namespace

std::string derivation_text(const Value& document) {
  return DerivationText().steps(document) + DerivationText::status(document);
}

std::string DerivationText::steps(const Value& document) { return Transcript().write_steps(document, next_, before_); }

std::string DerivationText::status(const Value& document) { return Transcript().write_end(document); }

}  // namespace race::semantics
