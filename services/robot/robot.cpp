#include "services/robot/robot.h"

#include "core/rsm/document.h"
#include "services/arguments.h"
#include "services/robot/behavior_value.h"
#include "services/robot/messages.h"

namespace race::robot {
namespace {

constexpr std::int64_t kStepsPerSample = 10;  // robot_state at 100 Hz

// A call of `move` that is refused takes `move` and at once `done`, which answers it with the error: nothing moves.
// BEHAVIOR stands for kBehaviorType, TOUCH for the data of contacts and collisions.
constexpr std::string_view kModel = R"json({
  "rsm": 1, "name": "robot",
  "operations": [
    {"name": "move", "parameters": [
       {"name": "target", "type": "any", "doc": "{position, orientation} of the tool centre point in o [m], {joints: [7]} [rad], or {offset: [3]} from here, along o [m]"},
       {"name": "behavior", "type": {"optional": BEHAVIOR}, "doc": "how it moves and reacts, from now on; else as it is"},
       {"name": "kind", "type": {"optional": {"enum": ["ptp", "lin", "free"]}}, "doc": "point-to-point, linear, or around what stands in the cell; else lin for an offset, ptp for others"},
       {"name": "speed", "type": "number", "min": 0.001, "max": 1, "value": 0.5, "doc": "share of the speed limits"},
       {"name": "acceleration", "type": "number", "min": 0.001, "max": 1, "value": 0.5, "doc": "share of the acceleration limits"},
       {"name": "carried", "type": {"optional": {"record": {"box": {"list": "number", "size": 3}}}}, "doc": "what the jaws hold, for free motions: edges [m] of a box around the tool centre point, along the tool's axes"}],
     "result": {"record": {"pose": "pose", "q": {"list": "number", "size": 7}}},
     "error": {"record": {"code": "string", "message": "string", "argument": {"optional": "string"}, "reaction": {"optional": "string"}}},
     "doc": "Moves the tool centre point and answers when it has arrived, or with the signal of the reflex that interrupted it."},
    {"name": "stop", "safe": true, "doc": "Brakes as hard as it may and holds; a move is answered `stopped`."},
    {"name": "change_behavior", "parameters": [
       {"name": "behavior", "type": "any", "doc": "as of move, or the name of a mode"}],
     "error": {"record": {"code": "string", "message": "string", "argument": {"optional": "string"}}},
     "doc": "How it holds, or gives way, and reacts from now on."},
    {"name": "speed_override", "parameters": [
       {"name": "share", "type": "number", "min": 0, "max": 1, "doc": "of the planned speed; 0 pauses on the path"}],
     "error": {"record": {"code": "string", "message": "string", "argument": {"optional": "string"}}},
     "doc": "Scales the speed of all motions, the present one too."},
    {"name": "record_pose",
     "result": {"record": {"pose": "pose", "q": {"list": "number", "size": 7}}},
     "error": {"record": {"code": "string", "message": "string"}},
     "doc": "Where a hand has led the arm: in gravity compensation."}
  ],
  "events": [
    {"name": "robot_state", "sampled": true, "rate_hz": 100, "doc": "pose and external force at the tool centre point, in o",
     "data": {"record": {"q": {"list": "number", "size": 7}, "dq": {"list": "number", "size": 7},
       "tau": {"list": "number", "size": 7}, "pose": "pose", "f_ext_hat": {"list": "number", "size": 3},
       "m_ext_hat": {"list": "number", "size": 3}, "tau_ext_hat": {"list": "number", "size": 7}}}},
    {"name": "contact", "doc": "an external joint torque has passed its threshold; `link`: where, or farther out", "data": TOUCH},
    {"name": "collision", "doc": "a contact that is accidental or more than light; again when it becomes more severe", "data": TOUCH},
    {"name": "force_limit", "data": {"record": {"reaction": "string", "f_ext_hat": {"list": "number", "size": 3},
       "m_ext_hat": {"list": "number", "size": 3}, "tau_ext_hat": {"list": "number", "size": 7}}}},
    {"name": "virtual_wall", "data": {"record": {"reaction": "string", "pose": "pose"}}},
    {"name": "joint_limit", "data": {"record": {"reaction": "string", "joint": "int", "q": {"list": "number", "size": 7}}}}
  ],
  "states": [
    {"name": "Idle", "events": ["robot_state", "contact", "collision", "force_limit", "virtual_wall", "joint_limit"]},
    {"name": "Moving", "events": ["robot_state", "contact", "collision", "force_limit", "virtual_wall", "joint_limit"]}],
  "init": "Idle",
  "transitions": [
    {"id": "move", "src": "Idle", "dst": "Moving", "operation": "move", "defer": ["done"]},
    {"id": "done", "src": "Moving", "dst": "Idle"},
    {"id": "stop", "dst": "Idle", "operation": "stop", "error": "stopped"},
    {"id": "change_behavior", "src": "Idle", "dst": "Idle", "operation": "change_behavior"},
    {"id": "override", "src": "Idle", "dst": "Idle", "operation": "speed_override"},
    {"id": "override_moving", "src": "Moving", "dst": "Moving", "operation": "speed_override"},
    {"id": "record_pose", "src": "Idle", "dst": "Idle", "operation": "record_pose"}
  ]
})json";

constexpr std::string_view kTouchType = R"json({"record": {"link": "string",
  "severity": {"enum": ["light", "medium", "severe"]}, "classification": {"enum": ["accidental", "intended"]},
  "reaction": {"enum": ["none", "stop", "gravity_compensation", "retreat", "slow_down"]},
  "f_ext_hat": {"list": "number", "size": 3}, "m_ext_hat": {"list": "number", "size": 3},
  "tau_ext_hat": {"list": "number", "size": 7}}})json";

std::string with(std::string text, std::string_view word, std::string_view meaning) {
  for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + meaning.size()))
    text.replace(at, word.size(), meaning);
  return text;
}

Refusal to_refusal(const Error& error) { return {std::string(name(error.code)), error.path, error.message}; }

}  // namespace

const rsm::Service& model() {
  static const std::string text = with(with(std::string(kModel), "BEHAVIOR", kBehaviorType), "TOUCH", kTouchType);
  static const rsm::Service service = rsm::read_service_text(text, "services/robot").value();
  return service;
}

Expected<std::unique_ptr<Robot>> Robot::create(services::ServiceHost& host, world::World& world, unsigned seed) {
  ASSIGN_OR_RETURN(ArmModel arm, ArmModel::create(world.model(), world.scene().robot.o_t_base));
  return std::unique_ptr<Robot>(new Robot(host, world, std::move(arm), seed));
}

namespace {

ControlSettings seeded(unsigned seed) {
  ControlSettings settings = lwr_settings();
  settings.seed = seed;
  return settings;
}

}  // namespace

Robot::Robot(services::ServiceHost& host, world::World& world, ArmModel arm, unsigned seed)
    : host_(host),
      world_(world),
      clearance_(world.model(), world.scene()),
      unit_(std::move(arm), seeded(seed), world.q(), [this](const Joints& q, double margin) {
        return (with_part_ ? *with_part_ : clearance_).keeps(q, margin);
      }) {
  world_.set_torques(unit_.control(world_.q(), world_.dq()));
}

void Robot::call(const services::Call& call) {
  if (call.operation == "stop") {
    stop(call);
  } else if (call.operation == "speed_override") {
    speed_override(call);
  } else if (moving_ != 0) {
    host_.reject(call.id);
  } else if (call.operation == "move") {
    move(call);
  } else if (call.operation == "change_behavior") {
    change_behavior(call);
  } else if (call.operation == "record_pose") {
    record_pose(call);
  } else {
    host_.reject(call.id);
  }
}

void Robot::move(const services::Call& call) {
  host_.transition("move", call.id);
  moving_ = call.id;
  const auto arguments = services::bind_arguments(*services::find_operation(model(), "move"), call);
  if (!arguments) {
    finish_move(to_refusal(arguments.error()));
    return;
  }
  const auto action = read_move(*arguments);
  if (!action) {
    finish_move(action.error());
    return;
  }
  carry(action->carried);
  if (const auto accepted = unit_.move(action->command, action->behavior); !accepted) {
    finish_move(accepted.error());
  }
}

void Robot::carry(const std::optional<Vec3>& part) {
  with_part_.reset();
  if (!part) return;
  world::RobotModel loaded = world_.model();
  loaded.links[static_cast<std::size_t>(loaded.link("tcp"))].collisions.push_back(
      {{world::Shape::Kind::box, *part}, Pose{}});
  with_part_.emplace(loaded, world_.scene());
}

void Robot::finish_move(const std::optional<Refusal>& failure) {
  host_.transition("done");
  const services::CallId call = std::exchange(moving_, 0);
  if (failure) {
    host_.error(call, to_value(*failure));
  } else {
    host_.result(call, place());
  }
}

Value Robot::place() const {
  const RobotState state = unit_.state();
  return Dict{{"pose", to_value(state.pose)}, {"q", to_value(state.q)}};
}

void Robot::stop(const services::Call& call) {
  unit_.stop();
  host_.transition("stop", call.id);
  if (moving_ != 0) host_.error(std::exchange(moving_, 0), to_value(Refusal{"stopped", "", "the robot was stopped"}));
  host_.result(call.id, nullptr);
}

void Robot::change_behavior(const services::Call& call) {
  host_.transition("change_behavior", call.id);
  const auto arguments = services::bind_arguments(*services::find_operation(model(), "change_behavior"), call);
  if (!arguments) {
    host_.error(call.id, to_value(to_refusal(arguments.error())));
    return;
  }
  const auto behavior = read_behavior(*arguments->find("behavior"));
  if (!behavior) {
    host_.error(call.id, to_value(behavior.error()));
    return;
  }
  unit_.set_behavior(*behavior);
  host_.result(call.id, nullptr);
}

void Robot::speed_override(const services::Call& call) {
  host_.transition(moving_ == 0 ? "override" : "override_moving", call.id);
  const auto arguments = services::bind_arguments(*services::find_operation(model(), "speed_override"), call);
  if (!arguments) {
    host_.error(call.id, to_value(to_refusal(arguments.error())));
    return;
  }
  unit_.set_override(arguments->find("share")->to_double());
  host_.result(call.id, nullptr);
}

void Robot::record_pose(const services::Call& call) {
  host_.transition("record_pose", call.id);
  const auto arguments = services::bind_arguments(*services::find_operation(model(), "record_pose"), call);
  if (!arguments) {
    host_.error(call.id, to_value(to_refusal(arguments.error())));
    return;
  }
  if (unit_.behavior().operational.mode != Mode::gravity_compensation) {
    host_.error(call.id, to_value(Refusal{"behavior", "", "poses are recorded in gravity compensation"}));
    return;
  }
  host_.result(call.id, place());
}

void Robot::step() {
  world_.set_torques(unit_.control(world_.q(), world_.dq()));
  for (const Incident& incident : unit_.take_incidents()) host_.event(name(incident.signal), to_value(incident, unit_));
  if (world_.steps() % kStepsPerSample == 0) host_.event("robot_state", to_value(unit_.state()));
  if (const auto outcome = unit_.take_outcome(); outcome && moving_ != 0) finish_move(*outcome);
}

}  // namespace race::robot
