#include "core/value/json.h"
#include "services/robot/behavior_value.h"
#include "services/robot/robot.h"
#include "services/types.h"

namespace race::robot {
namespace {

namespace types = services::types;
using services::EventRow;
using services::OperationRow;

Value joints_type() { return types::list("number", 7); }
Value vector_type() { return types::list("number", 3); }
Value behavior_type() { return parse_json(kBehaviorType).value(); }
Value place_type() { return types::record({{"pose", "pose"}, {"q", joints_type()}}); }

/// Of an operation that refuses arguments.
Value error_type() {
  return types::record({{"code", "string"}, {"message", "string"}, {"argument", types::optional("string")}});
}

/// Of an operation that a reflex may interrupt.
Value motion_error_type() {
  return types::record({{"code", "string"},
                        {"message", "string"},
                        {"argument", types::optional("string")},
                        {"reaction", types::optional("string")}});
}

/// Data of the events `contact` and `collision`.
Value contact_type() {
  return types::record({{"link", "string"},
                        {"severity", types::one_of({"light", "medium", "severe"})},
                        {"classification", types::one_of({"accidental", "intended"})},
                        {"reaction", types::one_of({"none", "stop", "gravity_compensation", "retreat", "slow_down"})},
                        {"f_ext_hat", vector_type()},
                        {"m_ext_hat", vector_type()},
                        {"tau_ext_hat", joints_type()}});
}

std::vector<services::ParameterRow> move_parameters() {
  return {
      {.name = "target",
       .type = "any",
       .doc = "{position, orientation} of the tool centre point in o [m], {joints: [7]} [rad], or {offset: [3]} from "
              "here, along o [m]"},
      {.name = "behavior",
       .type = types::optional(behavior_type()),
       .doc = "how it moves and reacts, from now on; else as it is"},
      {.name = "kind",
       .type = types::optional(types::one_of({"ptp", "lin", "free"})),
       .doc = "point-to-point, linear, or around what stands in the cell; else lin for an offset, ptp for others"},
      {.name = "speed", .type = "number", .min = 0.001, .max = 1, .value = 0.5, .doc = "share of the speed limits"},
      {.name = "acceleration",
       .type = "number",
       .min = 0.001,
       .max = 1,
       .value = 0.5,
       .doc = "share of the acceleration limits"},
      {.name = "carried",
       .type = types::optional(types::record({{"box", vector_type()}})),
       .doc = "what the jaws hold, for free motions: edges [m] of a box around the tool centre point, along the tool's "
              "axes"},
  };
}

OperationRow move_row(services::Handler handler) {
  return {.name = "move",
          .handler = std::move(handler),
          .parameters = move_parameters(),
          .result = place_type(),
          .error = motion_error_type(),
          .moves = true,
          .doc =
              "Moves the tool centre point and answers when it has arrived, or with the signal of the reflex that "
              "interrupted it."};
}

OperationRow jog_row(services::Handler handler) {
  return {.name = "jog",
          .handler = std::move(handler),
          .parameters =
              {
                  {.name = "joints",
                   .type = types::optional(joints_type()),
                   .unit = "rad/s",
                   .doc = "of each joint, at most half of its speed limit; or else"},
                  {.name = "linear",
                   .type = types::optional(vector_type()),
                   .unit = "m/s",
                   .doc = "of the tool centre point, at most 0.25 m/s"},
                  {.name = "angular",
                   .type = types::optional(vector_type()),
                   .unit = "rad/s",
                   .doc = "of the tool, at most 1 rad/s"},
                  {.name = "frame",
                   .type = types::one_of({"o", "tool"}),
                   .value = "o",
                   .doc = "whose axes `linear` and `angular` are along"},
              },
          .error = motion_error_type(),
          .moves = true,
          .held = true,
          .doc =
              "Moves with this velocity from now on, for 0.25 s unless it is called again: while a person holds a "
              "button."};
}

OperationRow guide_row(services::Handler handler) {
  return {.name = "guide",
          .handler = std::move(handler),
          .error = motion_error_type(),
          .moves = true,
          .held = true,
          .doc =
              "Gives way to a hand that leads it, for 0.25 s unless it is called again: while a person holds a button. "
              "Then it brakes, and holds as before."};
}

EventRow robot_state_row() {
  return {.name = "robot_state",
          .data = types::record({{"q", joints_type()},
                                 {"dq", joints_type()},
                                 {"tau", joints_type()},
                                 {"pose", "pose"},
                                 {"f_ext_hat", vector_type()},
                                 {"m_ext_hat", vector_type()},
                                 {"tau_ext_hat", joints_type()}}),
          .sampled = true,
          .rate_hz = 100,
          .doc = "pose and external force at the tool centre point, in o"};
}

std::vector<EventRow> events() {
  return {
      robot_state_row(),
      {.name = "contact",
       .data = contact_type(),
       .doc = "an external joint torque has passed its threshold; `link`: where, or farther out"},
      {.name = "collision",
       .data = contact_type(),
       .doc = "a contact that is accidental or more than light; again when it becomes more severe"},
      {.name = "force_limit",
       .data = types::record({{"reaction", "string"},
                              {"f_ext_hat", vector_type()},
                              {"m_ext_hat", vector_type()},
                              {"tau_ext_hat", joints_type()}})},
      {.name = "virtual_wall", .data = types::record({{"reaction", "string"}, {"pose", "pose"}})},
      {.name = "joint_limit", .data = types::record({{"reaction", "string"}, {"joint", "int"}, {"q", joints_type()}})},
  };
}

/// In each state, all events may come.
rsm::ServiceState state(const char* name) {
  return {name, {"robot_state", "contact", "collision", "force_limit", "virtual_wall", "joint_limit"}};
}

}  // namespace

// A move that is refused takes `move` and at once `done`, which answers it with the error: nothing moves. A jog that is
// refused takes `jog`, is answered, and takes `jog_done` (Robot::end_refused); in the state Jogging it changes nothing.
// So it is with `guide`.
const services::OperationTable& Robot::operations() {
  static const services::OperationTable table(
      {
          .name = "robot",
          .operations =
              {
                  move_row(&Robot::move),
                  jog_row(&Robot::jog),
                  guide_row(&Robot::guide),
                  {.name = "stop",
                   .handler = &Robot::stop,
                   .safe = true,
                   .doc = "Brakes as hard as it may and holds; a move is answered `stopped`."},
                  {.name = "change_behavior",
                   .handler = &Robot::change_behavior,
                   .parameters = {{.name = "behavior", .type = "any", .doc = "as of move, or the name of a mode"}},
                   .error = error_type(),
                   .moves = true,
                   .doc = "How it holds, or gives way, and reacts from now on."},
                  {.name = "speed_override",
                   .handler = &Robot::speed_override,
                   .parameters = {{.name = "share",
                                   .type = "number",
                                   .min = 0,
                                   .max = 1,
                                   .doc = "of the planned speed; 0 pauses on the path"}},
                   .error = error_type(),
                   .moves = true,
                   .paces = true,
                   .doc = "Scales the speed of all motions, the present one too."},
                  {.name = "record_pose",
                   .handler = &Robot::record_pose,
                   .result = place_type(),
                   .error = types::record({{"code", "string"}, {"message", "string"}}),
                   .reads = true,
                   .doc = "Where a hand has led the arm: while it is guided, or in gravity compensation."},
                  {.name = "state",
                   .handler = &Robot::report_state,
                   .result = types::record({{"pose", "pose"},
                                            {"q", joints_type()},
                                            {"mode", types::one_of({"position", "joint_impedance",
                                                                    "cartesian_impedance", "gravity_compensation"})},
                                            {"moving", "bool"},
                                            {"speed_override", "number"}}),
                   .reads = true,
                   .doc = "Where it is now, and how it holds or gives way."},
              },
          .events = events(),
          .states = {state("Idle"), state("Moving"), state("Jogging"), state("Guiding")},
          .init = "Idle",
          .transitions =
              {
                  {.id = "move",
                   .src = "Idle",
                   .dst = "Moving",
                   .operation = "move",
                   .defer = {"done"},
                   .refused = "done"},
                  {.id = "done", .src = "Moving", .dst = "Idle"},
                  {.id = "jog", .src = "Idle", .dst = "Jogging", .operation = "jog"},
                  {.id = "jog_on", .src = "Jogging", .dst = "Jogging", .operation = "jog"},
                  {.id = "jog_done", .src = "Jogging", .dst = "Idle"},
                  {.id = "guide", .src = "Idle", .dst = "Guiding", .operation = "guide"},
                  {.id = "guide_on", .src = "Guiding", .dst = "Guiding", .operation = "guide"},
                  {.id = "guide_done", .src = "Guiding", .dst = "Idle"},
                  {.id = "stop", .dst = "Idle", .operation = "stop", .error = "stopped"},
                  {.id = "change_behavior", .src = "Idle", .dst = "Idle", .operation = "change_behavior"},
                  {.id = "override", .src = "Idle", .dst = "Idle", .operation = "speed_override"},
                  {.id = "override_moving", .src = "Moving", .dst = "Moving", .operation = "speed_override"},
                  {.id = "override_jogging", .src = "Jogging", .dst = "Jogging", .operation = "speed_override"},
                  {.id = "override_guiding", .src = "Guiding", .dst = "Guiding", .operation = "speed_override"},
                  {.id = "record_pose", .src = "Idle", .dst = "Idle", .operation = "record_pose"},
                  {.id = "record_pose_guiding", .src = "Guiding", .dst = "Guiding", .operation = "record_pose"},
                  {.id = "state", .src = "Idle", .dst = "Idle", .operation = "state"},
                  {.id = "state_moving", .src = "Moving", .dst = "Moving", .operation = "state"},
                  {.id = "state_jogging", .src = "Jogging", .dst = "Jogging", .operation = "state"},
                  {.id = "state_guiding", .src = "Guiding", .dst = "Guiding", .operation = "state"},
              },
          .meta = Dict{{"flows", Dict{{"control", "how the arm holds or gives way, and the last collision it felt"}}}},
      });
  return table;
}

const rsm::Service& model() { return Robot::operations().model(); }

}  // namespace race::robot
