#include "server/cell/operator_script.h"

#include <limits>

#include "core/value/error_list.h"
#include "core/value/json.h"
#include "services/display/screens.h"

namespace race::server {
namespace {

using Need = Fields::Need;
constexpr double kLongest = 86400;  // s

std::string at(const std::string& path, std::size_t i) { return path + "/" + std::to_string(i); }

double seconds(Fields& fields, const char* name) {
  const double value = fields.number(name).value_or(0);
  if (!(value >= 0 && value <= kLongest))
    fields.violation(ErrorCode::out_of_range, std::string("`") + name + "` must be a number from 0 to 86400 s");
  return value;
}

OnEvent read_event(const Value& value, const std::string& path, std::vector<Error>& errors) {
  Fields fields(value, path, "the event", errors);
  OnEvent on{
      fields.text("service", Need::required).value_or(""), fields.text("event", Need::required).value_or(""), {}};
  if (const Value* data = fields.find("data")) {
    if (data->is_dict()) on.data = data->as_dict();
    if (!data->is_dict()) fields.violation(ErrorCode::type, "`data` must be an object");
  }
  fields.close();
  return on;
}

OnDisplay read_display(const Value& value, const std::string& path, std::vector<Error>& errors) {
  Fields fields(value, path, "the display", errors);
  OnDisplay on{fields.text("name").value_or(""), fields.text("text").value_or(""), fields.text("button").value_or("")};
  fields.close();
  return on;
}

When read_when(const Value& value, const std::string& path, std::vector<Error>& errors) {
  Fields fields(value, path, "`when`", errors);
  When when;
  when.after = seconds(fields, "after");
  int conditions = 0;
  if (fields.find("time")) {
    ++conditions;
    when.after += seconds(fields, "time");
    when.what = OnTime{true};
  }
  for (const bool active : {true, false}) {
    const char* name = active ? "active" : "inactive";
    if (!fields.find(name)) continue;
    ++conditions;
    when.what = OnState{fields.text(name).value_or(""), active};
  }
  if (fields.find("fires")) {
    ++conditions;
    when.what = OnPort{fields.text("fires").value_or("")};
  }
  if (const Value* event = fields.find("event")) {
    ++conditions;
    when.what = read_event(*event, path + "/event", errors);
  }
  if (const Value* display = fields.find("display")) {
    ++conditions;
    when.what = read_display(*display, path + "/display", errors);
  }
  if (conditions > 1)
    fields.violation(ErrorCode::duplicate,
                     "must have one of `time`, `active`, `inactive`, `fires`, `event`, `display`");
  if (const Value* count = fields.find("count")) {
    const bool fits = count->is_integer() && count->as_integer() >= 1 && count->as_integer() <= 1000000;
    if (fits) when.count = static_cast<int>(count->as_integer());
    if (!fits) fields.violation(ErrorCode::out_of_range, "`count` must be an integer from 1");
  }
  fields.close();
  return when;
}

std::variant<PersonCommand, AnswerCommand> read_act(const Value& value, const std::string& path,
                                                    std::vector<Error>& errors) {
  Fields fields(value, path, "the act", errors);
  const Value* kind = value.find("act");
  std::variant<PersonCommand, AnswerCommand> act;
  if (kind && *kind == Value("answer")) {
    fields.find("act");
    AnswerCommand answer{fields.text("display").value_or(""), {}};
    const auto button = fields.text("button");
    const auto number = fields.number("number");
    if (button.has_value() == number.has_value())
      fields.violation(ErrorCode::missing, "must have one of `button` and `number`");
    if (button) answer.answer = *button;
    if (number) answer.answer = *number;
    act = std::move(answer);
  } else {
    act = read_person_command(fields, std::numeric_limits<double>::infinity());
  }
  fields.close();
  return act;
}

ScriptedAct read_scripted(const Value& value, const std::string& path, std::vector<Error>& errors) {
  Fields fields(value, path, "the entry", errors);
  ScriptedAct scripted;
  scripted.doc = fields.text("doc").value_or("");
  scripted.always = fields.boolean("always").value_or(false);
  if (const Value* when = fields.find("when")) scripted.when = read_when(*when, path + "/when", errors);
  if (scripted.always && std::holds_alternative<OnTime>(scripted.when.what))
    fields.violation(ErrorCode::missing, "what happens always needs something that happens to wait for");
  if (const Value* acts = fields.find("do", Need::required)) {
    const List alone{*acts};
    const List& all = acts->is_list() ? acts->as_list() : alone;
    for (std::size_t i = 0; i < all.size(); ++i)
      scripted.acts.push_back(read_act(all[i], acts->is_list() ? at(path + "/do", i) : path + "/do", errors));
  }
  fields.close();
  return scripted;
}

const std::string* body_of(const PersonCommand& act) {
  struct Body {
    const std::string* operator()(const GrabCommand& act) const { return &act.hold.body; }
    const std::string* operator()(const world::Push& push) const { return &push.body; }
    const std::string* operator()(const PlaceCommand& act) const { return &act.part; }
    const std::string* operator()(const TakeCommand& act) const { return &act.part; }
    const std::string* operator()(const DragCommand&) const { return nullptr; }
    const std::string* operator()(const ReleaseCommand&) const { return nullptr; }
  };
  return std::visit(Body(), act.what);
}

void check_word(const std::optional<std::string>& word, const char* of, Fields& fields) {
  if (word && !display::is_display_name(*word))
    fields.violation(ErrorCode::name, "`" + *word + "` cannot name a " + of);
}

/// {name, place?}, or the name alone.
ScriptedDisplay read_scripted_display(const Value& value, const std::string& path, std::vector<Error>& errors) {
  const Value object = value.is_string() ? Value(Dict{{"name", value}}) : value;
  Fields fields(object, path, "the display", errors);
  const auto name = fields.text("name", Need::required), place = fields.text("place");
  fields.close();
  check_word(name, "display", fields);
  check_word(place, "place", fields);
  return {name.value_or(""), place.value_or("")};
}

}  // namespace

Checked<OperatorScript> read_operator_script(const Value& document) {
  std::vector<Error> errors;
  Fields fields(document, "", "the script", errors);
  const Value* version = fields.find("operator", Need::required);
  if (version && !(*version == Value(1))) fields.violation(ErrorCode::version, "`operator` must be 1");
  fields.text("doc");
  OperatorScript script;
  const List& displays = fields.list("displays");
  for (std::size_t i = 0; i < displays.size(); ++i)
    script.displays.push_back(read_scripted_display(displays[i], at("displays", i), errors));
  const List& acts = fields.list("acts", Need::required);
  for (std::size_t i = 0; i < acts.size(); ++i) script.acts.push_back(read_scripted(acts[i], at("acts", i), errors));
  fields.close();
  if (!errors.empty()) return tl::unexpected(std::move(errors));
  return script;
}

Checked<OperatorScript> read_operator_text(std::string_view text) {
  auto document = parse_json(text);
  if (!document) return tl::unexpected(std::vector<Error>{std::move(document).error()});
  return read_operator_script(*document);
}

std::vector<Error> check_bodies(const OperatorScript& script, const CellWorld& world) {
  std::vector<Error> errors;
  for (std::size_t i = 0; i < script.acts.size(); ++i)
    for (const auto& act : script.acts[i].acts) {
      const auto* person = std::get_if<PersonCommand>(&act);
      const std::string* body = person ? body_of(*person) : nullptr;
      if (body && !world.may_have(*body))
        add_error(errors, {ErrorCode::not_found, "there is no link or part `" + *body + "`", at("acts", i)});
    }
  return errors;
}

}  // namespace race::server
