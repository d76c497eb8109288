#include "services/display/remote_display_backend.h"

#include <algorithm>
#include <array>
#include <utility>

#include "services/display/arguments.h"
#include "services/display/display.h"
#include "services/host_function.h"

namespace race::display {
namespace {

using services::refusal_reply;

constexpr std::array<std::string_view, 4> kEventKinds = {"answered", "pressed", "connected", "disconnected"};

List texts(const std::vector<std::string>& from) { return {from.begin(), from.end()}; }

Value event_json(const DisplayEvent& event) {
  return Dict{{"kind", kEventKinds[static_cast<std::size_t>(event.kind)]},
              {"display", event.display},
              {"value", event.value},
              {"question", static_cast<std::int64_t>(event.question)},
              {"place", event.place}};
}

std::optional<DisplayEvent> read_event(const Value& json) {
  const Value *kind = json.find("kind"), *display = json.find("display"), *value = json.find("value"),
              *question = json.find("question"), *place = json.find("place");
  if (!kind || !kind->is_string() || !display || !display->is_string() || !value || !question ||
      !question->is_integer() || !place || !place->is_string())
    return std::nullopt;
  const auto known = std::ranges::find(kEventKinds, kind->as_string());
  if (known == kEventKinds.end()) return std::nullopt;
  return DisplayEvent{static_cast<DisplayEvent::Kind>(known - kEventKinds.begin()), display->as_string(), *value,
                      static_cast<std::uint64_t>(question->as_integer()), place->as_string()};
}

// ---- The functions, at the server. What a process asks is held to what its component lets through.

Value id_json(std::uint64_t id) { return static_cast<std::int64_t>(id); }

Expected<Value> show(DisplayBackend& backend, const Dict& arguments) {
  ASSIGN_OR_RETURN(const std::string target, read_target(arguments));
  ASSIGN_OR_RETURN(Message message, read_message(arguments, ""));
  const auto shown = backend.show(target, std::move(message));
  return shown ? Value() : refusal_reply(shown.error());
}

Expected<Value> ask(DisplayBackend& backend, const Dict& arguments) {
  ASSIGN_OR_RETURN(const std::string target, read_target(arguments));
  ASSIGN_OR_RETURN(Question question, read_question(arguments));
  const auto id = backend.ask(target, std::move(question));
  return id ? id_json(*id) : refusal_reply(id.error());
}

Expected<Value> clear(DisplayBackend& backend, const Dict& arguments) {
  ASSIGN_OR_RETURN(const std::string target, read_target(arguments));
  const auto gone = backend.clear(target);
  return gone ? Value(*gone) : refusal_reply(gone.error());
}

Expected<Value> withdraw(DisplayBackend& backend, const Dict&) {
  backend.withdraw();
  return Value();
}

Expected<Value> asking(DisplayBackend& backend, const Dict&) { return Value(backend.asking()); }

Expected<Value> take(DisplayBackend& backend, const Dict&) {
  List all;
  for (const DisplayEvent& event : backend.take()) all.push_back(event_json(event));
  return Value(std::move(all));
}

using Function = services::HostFunction<DisplayBackend>;

constexpr std::array kFunctions = {
    Function{"show_text", show},           Function{"show_image", show},
    Function{"show_progress", show},       Function{"ask", ask},
    Function{"ask_number", ask},           Function{"clear", clear},
    Function{"withdraw", withdraw, false}, Function{"asking", asking, false},
    Function{"take", take, false},
};

}  // namespace

void RemoteDisplayBackend::invalidate() {
  taken_ = false;
  asking_.reset();
}

// What it changes, changes what is known, too.
Expected<Value> RemoteDisplayBackend::command(std::string_view function, Dict arguments) {
  auto answer = services::read_reply(server_(function, std::move(arguments)));
  invalidate();
  return answer;
}

Expected<void> RemoteDisplayBackend::show(const std::string& target, Message message) {
  Dict arguments{{"text", message.text}, {"display", target}};
  std::string_view function = "show_text";
  if (message.progress) {
    arguments.set("progress", *message.progress);
    function = "show_progress";
  } else {
    arguments.set("buttons", texts(message.buttons));
  }
  if (!message.image.empty()) {
    arguments.set("image", message.image);
    function = "show_image";
  }
  auto shown = command(function, std::move(arguments));
  if (!shown) return tl::unexpected(std::move(shown).error());
  return {};
}

Expected<std::uint64_t> RemoteDisplayBackend::ask(const std::string& target, Question question) {
  Dict arguments{{"question", question.text}, {"display", target}};
  if (!question.number) {
    arguments.set("buttons", texts(question.buttons));
    return services::read_id(command("ask", std::move(arguments)));
  }
  arguments.set("unit", question.number->unit);
  arguments.set("min", question.number->min);
  arguments.set("max", question.number->max);
  if (question.number->value) arguments.set("initial", *question.number->value);
  return services::read_id(command("ask_number", std::move(arguments)));
}

Expected<bool> RemoteDisplayBackend::clear(const std::string& target) {
  ASSIGN_OR_RETURN(const Value gone, command("clear", {{"display", target}}));
  return gone.is_bool() && gone.as_bool();
}

void RemoteDisplayBackend::withdraw() { (void)command("withdraw", {}); }

bool RemoteDisplayBackend::asking() {
  if (asking_) return *asking_;
  const auto answer = server_("asking", {});
  if (answer && answer->is_bool()) asking_ = answer->as_bool();
  return asking_.value_or(false);
}

std::vector<DisplayEvent> RemoteDisplayBackend::take() {
  std::vector<DisplayEvent> all;
  if (taken_) return all;
  const auto answer = server_("take", {});
  if (!answer || !answer->is_list()) return all;
  taken_ = true;
  for (const Value& json : answer->as_list())
    if (auto event = read_event(json)) all.push_back(std::move(*event));
  return all;
}

Expected<Value> answer_display_request(DisplayBackend& backend, std::string_view function, const Dict& arguments) {
  return services::call_host_function(model(), kFunctions, backend, function, arguments);
}

}  // namespace race::display
