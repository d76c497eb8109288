#include "services/gripper/gripper.h"

#include <utility>

#include "core/rsm/document.h"
#include "services/arguments.h"

namespace race::gripper {
namespace {

constexpr std::int64_t kStepsPerSample = 50;  // gripper_state at 20 Hz

// A call that is refused takes its transition and at once `done`, which answers it with the error: nothing moves.
constexpr std::string_view kModel = R"json({
  "rsm": 1, "name": "gripper",
  "operations": [
    {"name": "grasp", "parameters": [
       {"name": "width", "type": "number", "unit": "m", "min": 0, "max": 0.11, "value": 0, "doc": "of the part, or less"},
       {"name": "speed", "type": "number", "unit": "m/s", "min": 0.005, "max": 0.42, "value": 0.1},
       {"name": "force", "type": "number", "unit": "N", "min": 5, "max": 80, "value": 20}],
     "result": {"record": {"actual_width": "number", "held": "bool"}},
     "error": {"record": {"code": "string", "message": "string", "argument": {"optional": "string"}, "actual_width": {"optional": "number"}}},
     "doc": "Closes until the fingers meet something, then holds it with the force; `no_part` if they come to the width and meet nothing."},
    {"name": "release", "parameters": [
       {"name": "width", "type": "number", "unit": "m", "min": 0, "max": 0.11, "value": 0.11},
       {"name": "speed", "type": "number", "unit": "m/s", "min": 0.005, "max": 0.42, "value": 0.1}],
     "result": {"record": {"actual_width": "number"}},
     "error": {"record": {"code": "string", "message": "string", "argument": {"optional": "string"}, "actual_width": {"optional": "number"}}},
     "doc": "Moves the fingers to the width; `blocked` if something keeps them from it."},
    {"name": "stop", "safe": true, "doc": "Stands still; a part that is held stays held; a grasp or release is answered `stopped`."},
    {"name": "state", "result": {"record": {"width": "number", "holding": "bool"}}, "doc": "How the fingers are now."}
  ],
  "events": [
    {"name": "gripper_state", "sampled": true, "rate_hz": 20, "data": {"record": {"width": "number", "holding": "bool"}}},
    {"name": "lost", "data": {"record": {"width": "number", "holding": "bool"}}, "doc": "a held part has gone from between the fingers"}
  ],
  "states": [{"name": "Ready", "events": ["gripper_state", "lost"]}, {"name": "Moving", "events": ["gripper_state", "lost"]}],
  "init": "Ready",
  "transitions": [
    {"id": "grasp", "src": "Ready", "dst": "Moving", "operation": "grasp", "defer": ["done"]},
    {"id": "release", "src": "Ready", "dst": "Moving", "operation": "release", "defer": ["done"]},
    {"id": "done", "src": "Moving", "dst": "Ready"},
    {"id": "stop", "dst": "Ready", "operation": "stop", "error": "stopped"},
    {"id": "state", "src": "Ready", "dst": "Ready", "operation": "state"},
    {"id": "state_moving", "src": "Moving", "dst": "Moving", "operation": "state"}
  ]
})json";

Value with_argument(Value error, const std::string& argument) {
  if (!argument.empty()) error.mutable_dict().set("argument", Value(argument));
  return error;
}

}  // namespace

const rsm::Service& model() {
  static const rsm::Service service = rsm::read_service_text(kModel, "services/gripper").value();
  return service;
}

Gripper::Gripper(services::ServiceHost& host, world::World& world)
    : host_(host), world_(world), unit_(world.gripper_width()) {}

void Gripper::call(const services::Call& call) {
  const bool moves = call.operation == "grasp" || call.operation == "release";
  if (call.operation == "stop") {
    stop(call);
  } else if (call.operation == "state") {
    host_.transition(moving_ == 0 ? "state" : "state_moving", call.id);
    host_.result(call.id, state());
  } else if (moves && moving_ == 0) {
    move(call);
  } else {
    host_.reject(call.id);
  }
}

void Gripper::move(const services::Call& call) {
  host_.transition(call.operation, call.id);
  const auto arguments = services::bind_arguments(*services::find_operation(model(), call.operation), call);
  if (!arguments) {
    const Error& error = arguments.error();
    host_.transition("done");
    host_.error(call.id, with_argument(services::error_value(error), error.path));
    return;
  }
  moving_ = call.id;
  const double width = arguments->find("width")->to_double();
  const double speed = arguments->find("speed")->to_double();
  if (call.operation == "grasp") {
    unit_.grasp(width, speed, arguments->find("force")->to_double());
  } else {
    unit_.release(width, speed);
  }
}

void Gripper::finish(Outcome outcome) {
  host_.transition("done");
  const services::CallId call = std::exchange(moving_, 0);
  const Value width(unit_.width());
  const auto failure = [&](std::string_view code, std::string_view message) {
    Value error = services::error_value(code, message);
    error.mutable_dict().set("actual_width", width);
    host_.error(call, std::move(error));
  };
  switch (outcome) {
    case Outcome::held:
      return host_.result(call, Dict{{"actual_width", width}, {"held", Value(true)}});
    case Outcome::opened:
      return host_.result(call, Dict{{"actual_width", width}});
    case Outcome::no_part:
      return failure("no_part", "the fingers met nothing");
    case Outcome::blocked:
      return failure("blocked", "something keeps the fingers from the width");
  }
}

void Gripper::stop(const services::Call& call) {
  unit_.stop();
  host_.transition("stop", call.id);
  if (moving_ != 0) host_.error(std::exchange(moving_, 0), services::error_value("stopped", "the gripper was stopped"));
  host_.result(call.id, nullptr);
}

void Gripper::step() {
  world_.set_gripper_force(unit_.control(world_.gripper_width(), world_.gripper_speed()));
  if (unit_.take_loss()) host_.event("lost", state());
  if (world_.steps() % kStepsPerSample == 0) host_.event("gripper_state", state());
  if (const auto outcome = unit_.take_outcome(); outcome && moving_ != 0) finish(*outcome);
}

Value Gripper::state() const { return Dict{{"width", Value(unit_.width())}, {"holding", Value(unit_.holding())}}; }

}  // namespace race::gripper
