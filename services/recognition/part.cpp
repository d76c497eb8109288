// Reads and checks part files.
#include "services/recognition/part.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>
#include <sstream>

#include "core/value/fields.h"
#include "core/value/json.h"
#include "services/marker.h"
#include "services/recognition/geometry_internal.h"

namespace race::recognition {
namespace {

constexpr double kLargest = 1.0;  // m, of a part
constexpr int kHighestOrder = 12;

using Errors = std::vector<Error>;

/// `out.size()` numbers from `least` to `most`; violations of others.
template <std::size_t N>
void numbers(Fields& fields, std::string_view key, std::size_t count, double least, double most,
             std::array<double, N>& out) {
  const List& list = fields.list(key, Fields::Need::required);
  if (list.size() != count) {
    fields.violation(ErrorCode::type, "`" + std::string(key) + "` must be " + std::to_string(count) + " numbers");
    return;
  }
  for (std::size_t i = 0; i < count; ++i) {
    const double number = list[i].is_numeric() ? list[i].to_double() : std::nan("");
    if (!(number >= least && number <= most)) {
      fields.violation(ErrorCode::out_of_range, "`" + std::string(key) + "` must be numbers from " +
                                                    std::to_string(least) + " to " + std::to_string(most));
      return;
    }
    out[i] = number;
  }
}

void read_shape(const Value& json, const std::string& path, Piece& piece, Errors& errors) {
  Fields fields(json, path, "shape", errors);
  if (!fields.is_object()) return;
  const Dict& dict = json.as_dict();
  const std::string kind = dict.size() == 1 ? dict.begin()->first.as_string() : "";
  if (kind != "box" && kind != "cylinder" && kind != "sphere")
    return fields.violation(ErrorCode::type, "a shape is one of box, cylinder, sphere");
  piece.kind = kind == "box" ? Piece::Kind::box : kind == "cylinder" ? Piece::Kind::cylinder : Piece::Kind::sphere;
  numbers(fields, kind, kind == "box" ? 3 : kind == "cylinder" ? 2 : 1, 1e-3, kLargest, piece.size);
}

void read_pose(const Value& json, const std::string& path, Pose& pose, Errors& errors) {
  Fields fields(json, path, "pose", errors);
  numbers(fields, "position", 3, -kLargest, kLargest, pose.position);
  numbers(fields, "orientation", 4, -1, 1, pose.orientation);
  double square = 0;
  for (const double component : pose.orientation) square += component * component;
  if (std::abs(square - 1) > 1e-3) fields.violation(ErrorCode::out_of_range, "the orientation is no unit quaternion");
  for (double& component : pose.orientation) component /= std::sqrt(square);
  fields.close();
}

void read_colour(Fields& fields, std::array<std::uint8_t, 3>& colour) {
  const auto text = fields.text("colour", Fields::Need::required);
  if (!text) return;
  if (text->size() != 7 || text->front() != '#' || text->find_first_not_of("0123456789abcdefABCDEF", 1) != text->npos)
    return fields.violation(ErrorCode::type, "a colour is #rrggbb");
  for (std::size_t i = 0; i < 3; ++i)
    colour[i] = static_cast<std::uint8_t>(std::stoul(text->substr(1 + 2 * i, 2), nullptr, 16));
}

Piece read_piece(const Value& json, const std::string& path, Errors& errors) {
  Fields fields(json, path, "piece", errors);
  Piece piece;
  if (const Value* shape = fields.find("shape", Fields::Need::required))
    read_shape(*shape, path + ".shape", piece, errors);
  if (const Value* pose = fields.find("pose")) read_pose(*pose, path + ".pose", piece.x_t_piece, errors);
  read_colour(fields, piece.colour);
  fields.close();
  return piece;
}

RotationalSymmetry read_symmetry(const Value& json, const std::string& path, Errors& errors) {
  Fields fields(json, path, "turn", errors);
  RotationalSymmetry symmetry;
  numbers(fields, "axis", 3, -1, 1, symmetry.axis);
  const double length = to_eigen(symmetry.axis).norm();
  if (!(length > 1e-3)) fields.violation(ErrorCode::out_of_range, "the axis must not be zero");
  for (double& component : symmetry.axis) component /= length;
  const auto order = fields.number("order");
  if (!order || *order != std::floor(*order) || *order < 0 || *order > kHighestOrder)
    fields.violation(ErrorCode::out_of_range, "`order` must be an int from 0 (any angle) to 12");
  symmetry.order = static_cast<int>(order.value_or(1));
  fields.close();
  return symmetry;
}

Marker read_marker(const Value& json, const std::string& path, Errors& errors) {
  Fields fields(json, path, "marker", errors);
  Marker marker;
  const auto dictionary = fields.text("dictionary", Fields::Need::required);
  if (dictionary && *dictionary != services::kMarkerDictionary)
    fields.violation(ErrorCode::unknown_name,
                     "the one known dictionary is " + std::string(services::kMarkerDictionary));
  const auto id = fields.number("id");
  if (!id || *id != std::floor(*id) || *id < 0 || *id >= services::kMarkerIds)
    fields.violation(ErrorCode::out_of_range,
                     "`id` must be an int from 0 to " + std::to_string(services::kMarkerIds - 1));
  else
    marker.id = static_cast<int>(*id);
  marker.side = fields.number("side").value_or(0);
  if (!(marker.side >= 1e-3 && marker.side <= kLargest))
    fields.violation(ErrorCode::out_of_range, "`side` must be a number from 0.001 to " + std::to_string(kLargest));
  if (const Value* pose = fields.find("pose", Fields::Need::required))
    read_pose(*pose, path + ".pose", marker.x_t_marker, errors);
  fields.close();
  return marker;
}

Part read_part(const Value& json, const std::string& path, Errors& errors) {
  Fields fields(json, path, "part", errors);
  Part part;
  part.label = fields.text("label", Fields::Need::required).value_or("");
  if (part.label.empty()) fields.violation(ErrorCode::missing, "a part needs a label");
  std::size_t i = 0;
  for (const Value& piece : fields.list("pieces", Fields::Need::required))
    part.pieces.push_back(read_piece(piece, path + ".pieces[" + std::to_string(i++) + "]", errors));
  if (part.pieces.empty()) fields.violation(ErrorCode::missing, "a part needs a piece");
  std::set<std::array<std::uint8_t, 3>> colours;
  for (const Piece& piece : part.pieces) colours.insert(piece.colour);
  if (colours.size() != 1 && (colours.size() != part.pieces.size() || colours.size() < 3))
    fields.violation(ErrorCode::out_of_range, "pieces have one colour, or at least three, each its own");
  i = 0;
  for (const Value& turn : fields.list("symmetry"))
    part.symmetry.push_back(read_symmetry(turn, path + ".symmetry[" + std::to_string(i++) + "]", errors));
  for (const Value& marker : fields.list("markers"))
    part.markers.push_back(read_marker(marker, path + ".markers[" + std::to_string(part.markers.size()) + "]", errors));
  if (!part.markers.empty() && std::ranges::count(part.symmetry, 0, &RotationalSymmetry::order) > 0)
    fields.violation(ErrorCode::out_of_range, "what has markers cannot be turned by any angle");
  fields.close();
  return part;
}

Vector half_edges(const Piece& piece) {
  switch (piece.kind) {
    case Piece::Kind::box:
      return to_eigen(piece.size) / 2;
    case Piece::Kind::cylinder:
      return {piece.size[0], piece.size[0], piece.size[1] / 2};
    case Piece::Kind::sphere:
      break;
  }
  return Vector::Constant(piece.size[0]);
}

}  // namespace

Expected<std::vector<Part>> read_parts(const Value& document) {
  Errors errors;
  std::vector<Part> parts;
  {
    Fields fields(document, "", "document", errors);
    if (const Value* version = fields.find("version", Fields::Need::required); version && *version != Value(1))
      fields.violation(ErrorCode::version, "expected version 1");
    std::set<std::string> labels;
    for (const Value& part : fields.list("parts", Fields::Need::required)) {
      const std::string path = "parts[" + std::to_string(parts.size()) + "]";
      parts.push_back(read_part(part, path, errors));
      if (!labels.insert(parts.back().label).second)
        errors.push_back({ErrorCode::duplicate, "another part has the label `" + parts.back().label + "`", path});
    }
    fields.close();
  }
  if (!errors.empty()) return tl::unexpected(std::move(errors.front()));
  return parts;
}

Expected<std::vector<Part>> load_parts(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  if (!file || !(text << file.rdbuf())) return unexpected(ErrorCode::io, "cannot read the file", path);
  ASSIGN_OR_RETURN(const Value document, parse_json(text.str()));
  return read_parts(document);
}

Box bounding_box(const Part& part) {
  Vector low = Vector::Constant(1e9), high = -low;
  for (const Piece& piece : part.pieces) {
    // Of a turned piece, the box around its box.
    const Vector half = rotation(piece.x_t_piece.orientation).cwiseAbs() * half_edges(piece);
    low = low.cwiseMin(to_eigen(piece.x_t_piece.position) - half);
    high = high.cwiseMax(to_eigen(piece.x_t_piece.position) + half);
  }
  const Vector middle = (low + high) / 2, half = (high - low) / 2;
  return {{middle.x(), middle.y(), middle.z()}, {half.x(), half.y(), half.z()}};
}

}  // namespace race::recognition
