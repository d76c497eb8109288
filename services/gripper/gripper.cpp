#include "services/gripper/gripper.h"

#include <utility>

namespace race::gripper {
namespace {

constexpr std::int64_t kStepsPerSample = 50;  // gripper_state at 20 Hz

}  // namespace

Gripper::Gripper(services::ServiceHost& host, world::World& world)
    : TableComponent(operations(), host), world_(world), unit_(world.gripper_width()) {}

void Gripper::grasp(const services::Call& call, const Dict& arguments) {
  moving_ = call.id;
  unit_.grasp(arguments.find("width")->to_double(), arguments.find("speed")->to_double(),
              arguments.find("force")->to_double());
}

void Gripper::release(const services::Call& call, const Dict& arguments) {
  moving_ = call.id;
  unit_.release(arguments.find("width")->to_double(), arguments.find("speed")->to_double());
}

void Gripper::finish(Outcome outcome) {
  take("done");
  const services::CallId call = std::exchange(moving_, 0);
  const Value width(unit_.width());
  const auto failure = [&](std::string_view code, std::string_view message) {
    Value error = services::error_value(code, message);
    error.mutable_dict().set("actual_width", width);
    host().error(call, std::move(error));
  };
  switch (outcome) {
    case Outcome::held:
      return host().result(call, Dict{{"actual_width", width}, {"held", Value(true)}});
    case Outcome::opened:
      return host().result(call, Dict{{"actual_width", width}});
    case Outcome::no_part:
      return failure("no_part", "the fingers met nothing");
    case Outcome::blocked:
      return failure("blocked", "something keeps the fingers from the width");
  }
}

void Gripper::stop(const services::Call& call) {
  unit_.stop();
  if (moving_ != 0)
    host().error(std::exchange(moving_, 0), services::error_value("stopped", "the gripper was stopped"));
  host().result(call.id, nullptr);
}

void Gripper::halt() {
  unit_.stop();
  if (moving_ == 0) return;
  take("done");
  host().error(std::exchange(moving_, 0), services::error_value("stopped", "the server was silent"));
}

void Gripper::report_state(const services::Call& call) { host().result(call.id, state()); }

void Gripper::step() {
  world_.set_gripper_force(unit_.control(world_.gripper_width(), world_.gripper_speed()));
  if (unit_.take_loss()) host().event("lost", state());
  if (world_.steps() % kStepsPerSample == 0) host().event("gripper_state", state());
  if (const auto outcome = unit_.take_outcome(); outcome && moving_ != 0) finish(*outcome);
}

Value Gripper::state() const { return Dict{{"width", Value(unit_.width())}, {"holding", Value(unit_.holding())}}; }

}  // namespace race::gripper
