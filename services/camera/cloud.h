// Cloud: the points that a picture measures, in the camera's frame.
#pragma once

#include "services/camera/intrinsics.h"
#include "services/camera/noise.h"
#include "services/component.h"

namespace race::camera {

/// The packet of the flow `cloud` (README.md): every pixel with a measurement, by rows from the top left.
services::PacketPtr to_cloud(const Measurement& picture, const Intrinsics& intrinsics, services::Time time);

}  // namespace race::camera
