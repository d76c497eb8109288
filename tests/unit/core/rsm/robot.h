// The robot service of Fig. 4.1, with an event for each way to emit one; for tests.
#pragma once

#include "core/rsm/document.h"

namespace race::rsm {

inline Service read_robot() {
  return read_service_text(R"({
    "rsm": 1, "name": "robot",
    "operations": [
      {"name": "move", "parameters": [{"name": "pose", "type": "pose"}, {"name": "speed", "type": "number", "value": 1.0}],
       "result": {"record": {"duration": "number"}}, "error": {"record": {"code": "string"}}},
      {"name": "stop", "safe": true},
      {"name": "change_behavior", "parameters": [{"name": "name", "type": {"enum": ["stiff", "soft"]}}]}],
    "events": [{"name": "robot_state", "data": "int", "sampled": true, "rate_hz": 100.0}, {"name": "started"}],
    "states": [{"name": "Idle", "events": ["robot_state"]}, {"name": "Moving"}], "init": "Idle",
    "transitions": [
      {"id": "start", "src": "Idle", "dst": "Moving", "operation": "move", "events": ["started"], "defer": ["arrive"]},
      {"id": "again", "src": "Moving", "dst": "Moving", "operation": "move", "defer": ["arrive"]},
      {"id": "arrive", "src": "Moving", "dst": "Idle"},
      {"id": "change", "src": "Idle", "dst": "Idle", "operation": "change_behavior"},
      {"id": "stop", "dst": "Idle", "operation": "stop", "error": "aborted"}]})",
                           "services/robot")
      .value();
}

}  // namespace race::rsm
