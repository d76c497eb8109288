// An operator script: what a person at the cell does by itself, and when (schemas/operator.json; format in README.md).
#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "server/cell/cell_world.h"
#include "server/cell/person_command.h"

namespace race::server {

/// Waits for nothing but time: since the act before, or, `absolute`, since the script began.
struct OnTime {
  bool absolute = false;
};
/// A state or barrier becomes active, or inactive. One that is so already counts as the first time.
struct OnState {
  std::string path;
  bool active = true;
};
struct OnPort {
  std::string port;  // fires: Root/A.success
};
struct OnEvent {
  std::string service, event;
  Dict data;  // fields that the event's data must have
};
/// A display shows a question or a message. Texts are parts of what is shown; empty ones fit all.
struct OnDisplay {
  std::string display, text, button;
};

struct When {
  std::variant<OnTime, OnState, OnPort, OnEvent, OnDisplay> what;
  double after = 0;  // s later, of world time
  int count = 1;     // only the n-th time, counted from the act before
};

/// A button of what a display shows, or a number for its question.
struct AnswerCommand {
  std::string display;  // empty: the one that the act waited for
  Value answer;
};

struct ScriptedAct {
  When when;
  std::vector<std::variant<PersonCommand, AnswerCommand>> acts;  // at once
  bool always = false;  // every time from the beginning on, beside the sequence
  std::string doc;
};

/// A display that the person stands before.
struct ScriptedDisplay {
  std::string name, place;  // place: empty: nowhere in particular
};

struct OperatorScript {
  std::vector<ScriptedDisplay> displays;  // they are connected and hear
  std::vector<ScriptedAct> acts;
};

/// Reads a script; lists all violations, `acts/2/do/0` is a path.
Checked<OperatorScript> read_operator_script(const Value& document);
/// From a text; its own codes, with an empty path: those of parse_json.
Checked<OperatorScript> read_operator_text(std::string_view text);

/// What the script names that the world does not have for sure.
std::vector<Error> check_bodies(const OperatorScript& script, const CellWorld& world);

}  // namespace race::server
