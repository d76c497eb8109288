// The RSM of the display. One question waits at a time, for all cores: another one takes its place. A call that is
// refused takes `refused` at once, or `refuse_...` while a question waits, which goes on waiting.
#include "core/rsm/document.h"
#include "services/display/display.h"

namespace race::display {
namespace {

constexpr std::string_view kModel = R"json({
  "rsm": 1, "name": "display",
  "operations": [
    {"name": "show_text", "parameters": [
       {"name": "text", "type": "string"},
       {"name": "buttons", "type": {"list": "string"}, "value": [], "doc": "each press is the event `button`"},
       {"name": "display", "type": "string", "value": "all"}],
     "error": {"record": {"code": "string", "message": "string", "argument": {"optional": "string"}}},
     "doc": "Shows a text until something else is shown."},
    {"name": "show_image", "parameters": [
       {"name": "image", "type": "string", "doc": "a data URL, or a file of the cell's folder"},
       {"name": "text", "type": "string", "value": "", "doc": "below the image"},
       {"name": "buttons", "type": {"list": "string"}, "value": [], "doc": "each press is the event `button`"},
       {"name": "display", "type": "string", "value": "all"}],
     "error": {"record": {"code": "string", "message": "string", "argument": {"optional": "string"}}},
     "doc": "Shows an image until something else is shown."},
    {"name": "ask", "parameters": [
       {"name": "question", "type": "string"},
       {"name": "buttons", "type": {"list": "string"}, "value": ["OK"]},
       {"name": "display", "type": "string", "value": "all"}],
     "result": {"record": {"answer": "string", "display": "string"}},
     "error": {"record": {"code": "string", "message": "string", "argument": {"optional": "string"}}},
     "doc": "Answers when a person has pressed one of the buttons, on whichever display."},
    {"name": "choose", "parameters": [
       {"name": "question", "type": "string"},
       {"name": "choices", "type": {"list": "string"}},
       {"name": "display", "type": "string", "value": "all"}],
     "result": "string",
     "error": {"record": {"code": "string", "message": "string", "argument": {"optional": "string"}}},
     "doc": "As ask, but answers the choice alone: made for external oracles."},
    {"name": "ask_number", "parameters": [
       {"name": "question", "type": "string"},
       {"name": "min", "type": "number", "min": -1e9, "max": 1e9},
       {"name": "max", "type": "number", "min": -1e9, "max": 1e9},
       {"name": "unit", "type": "string", "value": ""},
       {"name": "initial", "type": {"optional": "number"}, "doc": "is proposed"},
       {"name": "display", "type": "string", "value": "all"}],
     "result": {"record": {"answer": "number", "display": "string"}},
     "error": {"record": {"code": "string", "message": "string", "argument": {"optional": "string"}}},
     "doc": "Answers when a person has entered a number of min .. max."},
    {"name": "clear", "parameters": [{"name": "display", "type": "string", "value": "all"}], "safe": true,
     "error": {"record": {"code": "string", "message": "string", "argument": {"optional": "string"}}},
     "doc": "Shows nothing any more; a question that no display shows then is answered `cleared`."}
  ],
  "events": [
    {"name": "answer", "data": {"record": {"answer": "any", "display": "string"}}, "doc": "A question was answered."},
    {"name": "button", "data": {"record": {"button": "string", "display": "string"}}, "doc": "A button of what is shown was pressed."},
    {"name": "connected", "data": {"record": {"display": "string"}}, "doc": "A display is there."},
    {"name": "disconnected", "data": {"record": {"display": "string"}}, "doc": "A display is gone."}
  ],
  "states": [{"name": "Idle", "events": ["button", "connected", "disconnected"]},
             {"name": "Asking", "events": ["button", "connected", "disconnected"]}],
  "init": "Idle",
  "transitions": [
    {"id": "show_text", "src": "Idle", "dst": "Idle", "operation": "show_text"},
    {"id": "show_image", "src": "Idle", "dst": "Idle", "operation": "show_image"},
    {"id": "clear", "src": "Idle", "dst": "Idle", "operation": "clear"},
    {"id": "show_text_asking", "src": "Asking", "dst": "Asking", "operation": "show_text"},
    {"id": "show_image_asking", "src": "Asking", "dst": "Asking", "operation": "show_image"},
    {"id": "clear_asking", "src": "Asking", "dst": "Asking", "operation": "clear"},
    {"id": "ask", "src": "Idle", "dst": "Asking", "operation": "ask", "defer": ["answered", "refused", "lost", "cleared", "replaced"]},
    {"id": "choose", "src": "Idle", "dst": "Asking", "operation": "choose", "defer": ["answered", "refused", "lost", "cleared", "replaced"]},
    {"id": "ask_number", "src": "Idle", "dst": "Asking", "operation": "ask_number", "defer": ["answered", "refused", "lost", "cleared", "replaced"]},
    {"id": "refuse_ask", "src": "Asking", "dst": "Asking", "operation": "ask"},
    {"id": "refuse_choose", "src": "Asking", "dst": "Asking", "operation": "choose"},
    {"id": "refuse_ask_number", "src": "Asking", "dst": "Asking", "operation": "ask_number"},
    {"id": "answered", "src": "Asking", "dst": "Idle", "events": ["answer"]},
    {"id": "refused", "src": "Asking", "dst": "Idle"},
    {"id": "lost", "src": "Asking", "dst": "Idle", "error": "display_lost"},
    {"id": "cleared", "src": "Asking", "dst": "Idle", "error": "cleared"},
    {"id": "replaced", "src": "Asking", "dst": "Idle", "error": "replaced"}
  ]
})json";

}  // namespace

const rsm::Service& model() {
  static const rsm::Service service = rsm::read_service_text(kModel, "services/display").value();
  return service;
}

}  // namespace race::display
