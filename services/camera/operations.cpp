#include "services/camera/camera.h"
#include "services/types.h"

namespace race::camera {

namespace types = services::types;

const services::OperationTable& Camera::operations() {
  static const services::OperationTable table({
      .name = "KinectDriver",
      .operations = {{.name = "info",
                      .handler = &Camera::info,
                      .result = types::record({{"width", "number"},
                                               {"height", "number"},
                                               {"fx", "number"},
                                               {"fy", "number"},
                                               {"cx", "number"},
                                               {"cy", "number"},
                                               {"nearest", "number"},
                                               {"farthest", "number"},
                                               {"rate_hz", "number"}}),
                      .doc = "The pinhole [pixels], the range [m] and the rate [1/s]."}},
      .states = {{"Ready", {}}},
      .init = "Ready",
      .transitions = {{.id = "info", .src = "Ready", .dst = "Ready", .operation = "info"}},
      .meta = Dict{{"flows", Dict{{"frame", "depth and colour of 640x480 pixels"},
                                  {"cloud", "the points that were measured, with their colours"}}}},
  });
  return table;
}

const rsm::Service& model() { return Camera::operations().model(); }

}  // namespace race::camera
