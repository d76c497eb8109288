#include "services/robot/robot.h"

#include "core/rsm/document.h"
#include "services/arguments.h"
#include "services/robot/messages.h"

namespace race::robot {
namespace {

constexpr std::int64_t kStepsPerSample = 10;  // robot_state at 100 Hz

// A call of `move` that is refused takes `move` and at once `done`, which answers it with the error: nothing moves.
constexpr std::string_view kModel = R"json({
  "rsm": 1, "name": "robot",
  "operations": [
    {"name": "move", "parameters": [
       {"name": "target", "type": "any", "doc": "{position, orientation} of the tool centre point in o [m], {joints: [7]} [rad], or {offset: [3]} from here, along o [m]"},
       {"name": "kind", "type": {"optional": {"enum": ["ptp", "lin"]}}, "doc": "point-to-point or linear; else lin for an offset, ptp for others"},
       {"name": "speed", "type": "number", "min": 0.001, "max": 1, "value": 0.5, "doc": "share of the speed limits"},
       {"name": "acceleration", "type": "number", "min": 0.001, "max": 1, "value": 0.5, "doc": "share of the acceleration limits"}],
     "result": {"record": {"pose": "pose", "q": {"list": "number", "size": 7}}},
     "error": {"record": {"code": "string", "message": "string", "argument": {"optional": "string"}}},
     "doc": "Moves the tool centre point and answers when it has arrived."},
    {"name": "stop", "safe": true, "doc": "Brakes as hard as it may and holds; a move is answered `stopped`."},
    {"name": "change_behavior", "parameters": [
       {"name": "behavior", "type": {"enum": ["position", "gravity_compensation"]}}],
     "error": {"record": {"code": "string", "message": "string", "argument": {"optional": "string"}}},
     "doc": "Holds its position, or carries its own weight and can be led by hand."}
  ],
  "events": [
    {"name": "robot_state", "sampled": true, "rate_hz": 100, "doc": "pose and external force at the tool centre point, in o",
     "data": {"record": {"q": {"list": "number", "size": 7}, "dq": {"list": "number", "size": 7},
       "tau": {"list": "number", "size": 7}, "pose": "pose", "f_ext_hat": {"list": "number", "size": 3},
       "m_ext_hat": {"list": "number", "size": 3}, "tau_ext_hat": {"list": "number", "size": 7}}}},
    {"name": "contact", "doc": "an external joint torque has passed its threshold; `link`: where, or farther out",
     "data": {"record": {"link": "string", "f_ext_hat": {"list": "number", "size": 3},
       "m_ext_hat": {"list": "number", "size": 3}, "tau_ext_hat": {"list": "number", "size": 7}}}}
  ],
  "states": [{"name": "Idle", "events": ["robot_state", "contact"]}, {"name": "Moving", "events": ["robot_state", "contact"]}],
  "init": "Idle",
  "transitions": [
    {"id": "move", "src": "Idle", "dst": "Moving", "operation": "move", "defer": ["done"]},
    {"id": "done", "src": "Moving", "dst": "Idle"},
    {"id": "stop", "dst": "Idle", "operation": "stop", "error": "stopped"},
    {"id": "change_behavior", "src": "Idle", "dst": "Idle", "operation": "change_behavior"}
  ]
})json";

Refusal to_refusal(const Error& error) { return {std::string(name(error.code)), error.path, error.message}; }

}  // namespace

const rsm::Service& model() {
  static const rsm::Service service = rsm::read_service_text(kModel, "services/robot").value();
  return service;
}

Expected<std::unique_ptr<Robot>> Robot::create(services::ServiceHost& host, world::World& world) {
  ASSIGN_OR_RETURN(ArmModel arm, ArmModel::create(world.model(), world.scene().robot.o_t_base));
  return std::unique_ptr<Robot>(new Robot(host, world, std::move(arm)));
}

Robot::Robot(services::ServiceHost& host, world::World& world, ArmModel arm)
    : host_(host), world_(world), unit_(std::move(arm), lwr_settings(), world.q()) {
  world_.set_torques(unit_.control(world_.q(), world_.dq()));
}

void Robot::call(const services::Call& call) {
  if (call.operation == "stop") {
    stop(call);
  } else if (call.operation == "move" && moving_ == 0) {
    move(call);
  } else if (call.operation == "change_behavior" && moving_ == 0) {
    change_behavior(call);
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
  const auto command = read_move(*arguments);
  if (!command) {
    finish_move(command.error());
  } else if (const auto accepted = unit_.move(*command); !accepted) {
    finish_move(accepted.error());
  }
}

void Robot::finish_move(const std::optional<Refusal>& failure) {
  host_.transition("done");
  const services::CallId call = std::exchange(moving_, 0);
  if (failure) {
    host_.error(call, to_value(*failure));
  } else {
    const RobotState state = unit_.state();
    host_.result(call, Dict{{"pose", to_value(state.pose)}, {"q", to_value(state.q)}});
  }
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
  const bool position = arguments->find("behavior")->as_string() == "position";
  unit_.set_behavior(position ? Behavior::position : Behavior::gravity_compensation);
  host_.result(call.id, nullptr);
}

void Robot::step() {
  world_.set_torques(unit_.control(world_.q(), world_.dq()));
  if (const auto contact = unit_.take_contact()) host_.event("contact", contact_value(*contact, unit_));
  if (world_.steps() % kStepsPerSample == 0) host_.event("robot_state", to_value(unit_.state()));
  if (const auto outcome = unit_.take_outcome(); outcome && moving_ != 0) finish_move(*outcome);
}

}  // namespace race::robot
