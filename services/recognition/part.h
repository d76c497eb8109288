// Part: what recognition knows of a thing it looks for: shapes, colours and which turns change nothing about it. Read
// from a file (deploy/demo/parts.json is one). Values; any thread.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/value/expected.h"
#include "core/value/value.h"

namespace race::recognition {

using Vec3 = std::array<double, 3>;
using Quaternion = std::array<double, 4>;  // [qx, qy, qz, qw], of length 1

struct Pose {
  Vec3 position{};  // m
  Quaternion orientation{0, 0, 0, 1};
};

/// One coloured body of a part, centred in its own frame; cylinders stand along z.
struct Piece {
  enum class Kind { box, cylinder, sphere };
  Kind kind = Kind::box;
  Vec3 size{};  // m; box: edges; cylinder: radius, length; sphere: radius
  Pose x_t_piece;
  std::array<std::uint8_t, 3> colour{};  // red, green, blue
};

/// Turning the part about `axis` (in its frame) by a full turn / `order` changes nothing; order 0: by any angle.
struct RotationalSymmetry {
  Vec3 axis{0, 0, 1};
  int order = 1;
};

/// A printed marker (services/marker.h) on a part.
struct Marker {
  int id = 0;
  double side = 0;  // m, of the black square
  Pose x_t_marker;  // its middle; x to the right and y up of what is printed, z out of it towards who reads it
};

struct Part {
  std::string label;
  std::vector<Piece> pieces;                 // of one colour, or each of its own
  std::vector<RotationalSymmetry> symmetry;  // of the form: the markers may tell the turns apart
  std::vector<Marker> markers;               // none: whatever is printed on it, it is this part
};

/// Reads a document of parts. Errors name the field: `missing`, `type`, `unknown_field`, `out_of_range`, `duplicate` (a
/// label), `version`, `unknown_name` (a dictionary of markers).
Expected<std::vector<Part>> read_parts(const Value& document);

/// As read_parts, from a file. Errors also `io` and those of parse_json.
Expected<std::vector<Part>> load_parts(const std::string& path);

/// The half edges of the box around the part along the axes of its frame, and its middle.
struct Box {
  Vec3 middle{}, half{};
};
Box bounding_box(const Part& part);

}  // namespace race::recognition
