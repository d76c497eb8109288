// Identifying a part by its printed markers.
#pragma once

#include <optional>

#include "services/recognition/fit_internal.h"
#include "services/recognition/markers.h"

namespace race::recognition {

/// Of the poses that the form of a part with markers does not tell from `c_t_x`, the one in which its markers are where
/// markers were `seen`. None if none of its markers is seen, or if another one is where one of them should be.
std::optional<Transform> identify(const Model& model, const Transform& c_t_x, const std::vector<SeenMarker>& seen,
                                  const RgbdImage& image);

/// Whether a point on the surface of a part, in its frame, is under one of its markers or within 2 mm of one, so that
/// its colour says nothing.
bool is_printed(const Part& part, const Vector& point);

}  // namespace race::recognition
