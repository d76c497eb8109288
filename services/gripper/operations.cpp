#include "services/gripper/gripper.h"
#include "services/types.h"

namespace race::gripper {
namespace {

namespace types = services::types;

Value motion_error() {
  return types::record({{"code", "string"},
                        {"message", "string"},
                        {"argument", types::optional("string")},
                        {"actual_width", types::optional("number")}});
}

services::ParameterRow speed() {
  return {.name = "speed", .type = "number", .unit = "m/s", .min = 0.005, .max = 0.42, .value = 0.1};
}

services::OperationRow grasp_row(services::Handler handler) {
  return {.name = "grasp",
          .handler = std::move(handler),
          .parameters = {{.name = "width",
                          .type = "number",
                          .unit = "m",
                          .min = 0,
                          .max = 0.11,
                          .value = 0,
                          .doc = "of the part, or less"},
                         speed(),
                         {.name = "force", .type = "number", .unit = "N", .min = 5, .max = 80, .value = 20}},
          .result = types::record({{"actual_width", "number"}, {"held", "bool"}}),
          .error = motion_error(),
          .moves = true,
          .doc =
              "Closes until the fingers meet something, then holds it with the force; `no_part` if they come to the "
              "width and meet nothing."};
}

services::OperationRow release_row(services::Handler handler) {
  return {
      .name = "release",
      .handler = std::move(handler),
      .parameters = {{.name = "width", .type = "number", .unit = "m", .min = 0, .max = 0.11, .value = 0.11}, speed()},
      .result = types::record({{"actual_width", "number"}}),
      .error = motion_error(),
      .moves = true,
      .doc = "Moves the fingers to the width; `blocked` if something keeps them from it."};
}

Value state_type() { return types::record({{"width", "number"}, {"holding", "bool"}}); }

}  // namespace

// A grasp or release that is refused takes its transition and at once `done`, which answers it with the error: nothing
// moves.
const services::OperationTable& Gripper::operations() {
  static const services::OperationTable table({
      .name = "gripper",
      .operations =
          {
              grasp_row(&Gripper::grasp),
              release_row(&Gripper::release),
              {.name = "stop",
               .handler = &Gripper::stop,
               .safe = true,
               .doc = "Stands still; a part that is held stays held; a grasp or release is answered `stopped`."},
              {.name = "state",
               .handler = &Gripper::report_state,
               .result = state_type(),
               .reads = true,
               .doc = "How the fingers are now."},
          },
      .events =
          {
              {.name = "gripper_state", .data = state_type(), .sampled = true, .rate_hz = 20},
              {.name = "lost", .data = state_type(), .doc = "a held part has gone from between the fingers"},
          },
      .states = {{"Ready", {"gripper_state", "lost"}}, {"Moving", {"gripper_state", "lost"}}},
      .init = "Ready",
      .transitions =
          {
              {.id = "grasp",
               .src = "Ready",
               .dst = "Moving",
               .operation = "grasp",
               .defer = {"done"},
               .refused = "done"},
              {.id = "release",
               .src = "Ready",
               .dst = "Moving",
               .operation = "release",
               .defer = {"done"},
               .refused = "done"},
              {.id = "done", .src = "Moving", .dst = "Ready"},
              {.id = "stop", .dst = "Ready", .operation = "stop", .error = "stopped"},
              {.id = "state", .src = "Ready", .dst = "Ready", .operation = "state"},
              {.id = "state_moving", .src = "Moving", .dst = "Moving", .operation = "state"},
          },
  });
  return table;
}

const rsm::Service& model() { return Gripper::operations().model(); }

}  // namespace race::gripper
