#include "services/display/display.h"
#include "services/types.h"

namespace race::display {
namespace {

namespace types = services::types;
using services::Acceptance;
using services::OperationRow;
using services::ParameterRow;
using services::TransitionRow;

ParameterRow target() {
  return {.name = "display", .type = "string", .value = "all", .doc = "a name, @PLACE for all at a place, or all"};
}

ParameterRow question_text() { return {.name = "question", .type = "string"}; }

ParameterRow message_buttons() {
  return {.name = "buttons", .type = types::list("string"), .value = List(), .doc = "each press is the event `button`"};
}

OperationRow row(std::string name, services::Handler handler, std::vector<ParameterRow> parameters, Value result,
                 std::string doc, bool safe = false) {
  return {.name = std::move(name),
          .handler = std::move(handler),
          .parameters = std::move(parameters),
          .result = std::move(result),
          .error = types::record({{"code", "string"}, {"message", "string"}, {"argument", types::optional("string")}}),
          .safe = safe,
          .acceptance = Acceptance::by_handler,
          .doc = std::move(doc)};
}

Value answer_type(const char* answer) { return types::record({{"answer", answer}, {"display", "string"}}); }

std::vector<services::EventRow> events() {
  const Value display = types::record({{"display", "string"}, {"place", "string"}});
  return {
      {.name = "answer", .data = answer_type("any"), .doc = "A question was answered."},
      {.name = "button",
       .data = types::record({{"button", "string"}, {"display", "string"}}),
       .doc = "A button of what is shown was pressed."},
      {.name = "connected", .data = display, .doc = "A display is there, or at another place."},
      {.name = "disconnected", .data = display, .doc = "A display is gone."},
  };
}

TransitionRow in_idle(const char* operation) {
  return {.id = operation, .src = "Idle", .dst = "Idle", .operation = operation};
}

TransitionRow in_asking(const std::string& operation) {
  return {.id = operation + "_asking", .src = "Asking", .dst = "Asking", .operation = operation};
}

TransitionRow question(const char* operation) {
  return {.id = operation,
          .src = "Idle",
          .dst = "Asking",
          .operation = operation,
          .defer = {"answered", "refused", "lost", "cleared", "replaced"},
          .refused = "refused"};
}

TransitionRow refused_question(const std::string& operation) {
  return {.id = "refuse_" + operation, .src = "Asking", .dst = "Asking", .operation = operation};
}

std::vector<TransitionRow> transitions() {
  return {
      in_idle("show_text"),
      in_idle("show_image"),
      in_idle("show_progress"),
      in_idle("clear"),
      in_asking("show_text"),
      in_asking("show_image"),
      in_asking("show_progress"),
      in_asking("clear"),
      question("ask"),
      question("choose"),
      question("ask_number"),
      refused_question("ask"),
      refused_question("choose"),
      refused_question("ask_number"),
      {.id = "answered", .src = "Asking", .dst = "Idle", .events = {"answer"}},
      {.id = "refused", .src = "Asking", .dst = "Idle"},
      {.id = "lost", .src = "Asking", .dst = "Idle", .error = "display_lost"},
      {.id = "cleared", .src = "Asking", .dst = "Idle", .error = "cleared"},
      {.id = "replaced", .src = "Asking", .dst = "Idle", .error = "replaced"},
  };
}

}  // namespace

// One question waits at a time, for all cores; a new one replaces it. A refused question takes `refused` at once, or
// `refuse_...` while another waits, which goes on waiting.
const services::OperationTable& Display::operations() {
  static const services::OperationTable table({
      .name = "display",
      .operations =
          {
              row("show_text", &Display::show, {{.name = "text", .type = "string"}, message_buttons(), target()},
                  nullptr, "Shows a text until something else is shown."),
              row("show_image", &Display::show,
                  {{.name = "image", .type = "string", .doc = "a data URL, or a file of the cell's folder"},
                   {.name = "text", .type = "string", .value = "", .doc = "below the image"},
                   message_buttons(),
                   target()},
                  nullptr, "Shows an image until something else is shown."),
              row("show_progress", &Display::show,
                  {{.name = "text", .type = "string"},
                   {.name = "progress", .type = "number", .min = 0, .max = 1, .doc = "the share that is done"},
                   target()},
                  nullptr, "Shows a text and a bar until something else is shown."),
              row("ask", &Display::ask,
                  {question_text(), {.name = "buttons", .type = types::list("string"), .value = List{"OK"}}, target()},
                  answer_type("string"), "Answers when a person has pressed one of the buttons, on whichever display."),
              row("choose", &Display::ask,
                  {question_text(), {.name = "choices", .type = types::list("string")}, target()}, "string",
                  "As ask, but answers the choice alone: made for external oracles."),
              row("ask_number", &Display::ask,
                  {question_text(),
                   {.name = "min", .type = "number", .min = -1e9, .max = 1e9},
                   {.name = "max", .type = "number", .min = -1e9, .max = 1e9},
                   {.name = "unit", .type = "string", .value = ""},
                   {.name = "initial", .type = types::optional("number"), .doc = "is proposed"},
                   target()},
                  answer_type("number"), "Answers when a person has entered a number of min .. max."),
              row("clear", &Display::clear, {target()}, nullptr,
                  "Shows nothing any more; a question that no display shows then is answered `cleared`.", true),
          },
      .events = events(),
      .states = {{"Idle", {"button", "connected", "disconnected"}},
                 {"Asking", {"button", "connected", "disconnected"}}},
      .init = "Idle",
      .transitions = transitions(),
  });
  return table;
}

const rsm::Service& model() { return Display::operations().model(); }

}  // namespace race::display
