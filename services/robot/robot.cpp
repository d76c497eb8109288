#include "services/robot/robot.h"

#include "services/robot/behavior_value.h"
#include "services/robot/messages.h"

namespace race::robot {
namespace {

constexpr std::int64_t kStepsPerSample = 10;    // robot_state at 100 Hz
constexpr std::int64_t kStepsPerControl = 200;  // packets of `control` at 5 Hz
constexpr std::string_view kControl = "control";
constexpr std::string_view kJogDone = "jog_done", kGuideDone = "guide_done";

}  // namespace

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
    : TableComponent(operations(), host),
      world_(world),
      clearance_(world.model(), world.scene()),
      unit_(std::move(arm), seeded(seed), world.q(), [this](const Joints& q, double margin) {
        return (clearance_with_payload_ ? *clearance_with_payload_ : clearance_).keeps(q, margin);
      }) {
  world_.set_torques(unit_.control(world_.q(), world_.dq()));
}

void Robot::move(const services::Call& call, const Dict& arguments) {
  const auto action = read_move(arguments);
  if (!action) return refuse(call, to_value(action.error()));
  set_payload(action->carried);
  if (const auto accepted = unit_.move(action->command, action->behavior); !accepted)
    return refuse(call, to_value(accepted.error()));
  moving_ = call.id;
  explain_standstill();
}

/// A motion begins: whoever has set the override to 0 may have left long ago.
void Robot::explain_standstill() {
  if (unit_.speed_override() == 0)
    host().log("a motion waits at its start: `speed_override` is 0, and it goes on when somebody sets it above 0");
}

void Robot::set_payload(const std::optional<Vec3>& part) {
  clearance_with_payload_.reset();
  if (!part) return;
  world::RobotModel loaded = world_.model();
  loaded.links[static_cast<std::size_t>(loaded.link("tcp"))].collisions.push_back(
      {{world::Shape::Kind::box, *part}, Pose{}});
  clearance_with_payload_.emplace(loaded, world_.scene());
}

void Robot::jog(const services::Call& call, const Dict& arguments) {
  const auto wanted = read_jog(arguments);
  if (!wanted) return refuse_held(call, wanted.error());
  if (const auto accepted = unit_.jog(*wanted); !accepted) return refuse_held(call, accepted.error());
  if (std::exchange(held_, kJogDone).empty()) explain_standstill();
  host().result(call.id, nullptr);
}

void Robot::guide(const services::Call& call, const Dict&) {
  if (const auto accepted = unit_.guide(); !accepted) return refuse_held(call, accepted.error());
  held_ = kGuideDone;
  host().result(call.id, nullptr);
}

void Robot::refuse_held(const services::Call& call, const Refusal& refusal) {
  refuse(call, to_value(refusal));
  end_refused(call);
}

void Robot::refuse_arguments(const services::Call& call, const Error& error) {
  TableComponent::refuse_arguments(call, error);
  end_refused(call);
}

/// The state is Jogging or Guiding by a call that was refused, or still by one before it.
void Robot::end_refused(const services::Call& call) {
  if (!held_.empty()) return;
  if (call.operation == "jog") take(kJogDone);
  if (call.operation == "guide") take(kGuideDone);
}

/// The motion of the unit has ended.
void Robot::finish(const std::optional<Refusal>& failure) {
  if (moving_ != 0) finish_move(failure);
  if (const auto held = std::exchange(held_, {}); !held.empty()) take(held);
}

void Robot::finish_move(const std::optional<Refusal>& failure) {
  take("done");
  const services::CallId call = std::exchange(moving_, 0);
  if (failure) {
    host().error(call, to_value(*failure));
  } else {
    host().result(call, place());
  }
}

Value Robot::place() const {
  const RobotState state = unit_.state();
  return Dict{{"pose", to_value(state.pose)}, {"q", to_value(state.q)}};
}

void Robot::stop(const services::Call& call) {
  unit_.stop();
  held_ = {};
  if (moving_ != 0) host().error(std::exchange(moving_, 0), to_value(Refusal{"stopped", "", "the robot was stopped"}));
  host().result(call.id, nullptr);
}

void Robot::halt() {
  unit_.stop();
  finish(Refusal{"stopped", "", "the server was silent"});
}

void Robot::limit_speed(std::optional<double> tool_speed) { unit_.set_tool_speed_limit(tool_speed); }

void Robot::change_behavior(const services::Call& call, const Dict& arguments) {
  const auto behavior = read_behavior(*arguments.find("behavior"));
  if (!behavior) return refuse(call, to_value(behavior.error()));
  unit_.set_behavior(*behavior);
  host().result(call.id, nullptr);
}

void Robot::speed_override(const services::Call& call, const Dict& arguments) {
  unit_.set_override(arguments.find("share")->to_double());
  host().result(call.id, nullptr);
}

void Robot::record_pose(const services::Call& call, const Dict&) {
  const bool by_hand = held_ == kGuideDone || unit_.behavior().operational.mode == Mode::gravity_compensation;
  if (!by_hand) return refuse(call, to_value(Refusal{"behavior", "", "poses are recorded while a hand leads the arm"}));
  host().result(call.id, place());
}

void Robot::report_state(const services::Call& call) {
  Dict state = place().as_dict();
  state.set("mode", Value(name(unit_.behavior().operational.mode)));
  state.set("moving", unit_.moving());
  state.set("speed_override", unit_.speed_override());
  host().result(call.id, std::move(state));
}

void Robot::step() {
  world_.set_torques(unit_.control(world_.q(), world_.dq()));
  for (const Incident& incident : unit_.take_incidents()) announce(incident);
  if (world_.steps() % kStepsPerSample == 0) host().event("robot_state", to_value(unit_.state()));
  if (watched_ && world_.steps() % kStepsPerControl == 0) publish_control();
  if (const auto outcome = unit_.take_outcome()) finish(*outcome);
}

void Robot::demand_changed(std::string_view flow, bool on) {
  if (flow == kControl) watched_ = on;
}

void Robot::announce(const Incident& incident) {
  const Value data = to_value(incident, unit_);
  host().event(name(incident.signal), data);
  if (incident.signal != Signal::collision) return;
  Dict collision = data.as_dict();
  collision.set("time", host().now());
  collision_ = std::move(collision);
}

void Robot::publish_control() {
  auto packet = std::make_shared<services::Packet>();
  packet->time = host().now();
  packet->header = control_value(unit_, collision_);
  packet->header.freeze();
  host().publish(kControl, std::move(packet));
}

}  // namespace race::robot
