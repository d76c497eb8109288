// Reads scene files: every field is validated, with its path, before a world is built from it.
#include "services/world/scene.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <optional>
#include <set>
#include <span>
#include <sstream>

#include "core/value/json.h"
#include "services/marker.h"

namespace race::world {
namespace {

constexpr double kFarthest = 100.0;   // m; nothing of a cell is longer or farther away
constexpr double kHeaviest = 1000.0;  // kg

/// A dict with its place in the document; get() remembers nothing, check() refuses fields that are not named.
class Fields {
 public:
  static Expected<Fields> of(const Value& value, std::string path, std::initializer_list<std::string_view> known) {
    if (!value.is_dict()) return unexpected(ErrorCode::type, "expected an object", path);
    for (const auto& [key, unused] : value.as_dict()) {
      bool found = false;
      for (const auto name : known) found = found || key.as_string() == name;
      if (!found) return unexpected(ErrorCode::unknown_field, "no such field", path + "." + key.as_string());
    }
    return Fields(value, std::move(path));
  }

  std::string path(std::string_view name) const {
    return path_.empty() ? std::string(name) : path_ + "." + std::string(name);
  }

  Expected<const Value*> get(std::string_view name) const {
    const Value* value = value_->find(name);
    if (!value) return unexpected(ErrorCode::missing, "field is missing", path(name));
    return value;
  }

  Expected<std::string> text(std::string_view name) const {
    ASSIGN_OR_RETURN(const Value* value, get(name));
    if (!value->is_string() || value->as_string().empty())
      return unexpected(ErrorCode::type, "expected a text that is not empty", path(name));
    return value->as_string();
  }

  Expected<double> number(std::string_view name, double least, double most,
                          std::optional<double> otherwise = {}) const {
    if (otherwise && !value_->find(name)) return *otherwise;
    ASSIGN_OR_RETURN(const Value* value, get(name));
    return in_range(*value, least, most, path(name));
  }

  Expected<void> numbers(std::string_view name, std::span<double> out, double least, double most) const {
    ASSIGN_OR_RETURN(const Value* value, get(name));
    if (!value->is_list() || value->as_list().size() != out.size())
      return unexpected(ErrorCode::type, "expected a list of " + std::to_string(out.size()) + " numbers", path(name));
    for (std::size_t i = 0; i < out.size(); ++i) {
      ASSIGN_OR_RETURN(out[i], in_range(value->as_list()[i], least, most, path(name) + "[" + std::to_string(i) + "]"));
    }
    return {};
  }

 private:
  Fields(const Value& value, std::string path) : value_(&value), path_(std::move(path)) {}

  static Expected<double> in_range(const Value& value, double least, double most, const std::string& path) {
    if (!value.is_numeric()) return unexpected(ErrorCode::type, "expected a number", path);
    const double number = value.to_double();
    if (!(number >= least && number <= most)) {
      return unexpected(ErrorCode::out_of_range,
                        "expected a number from " + std::to_string(least) + " to " + std::to_string(most), path);
    }
    return number;
  }

  const Value* value_;
  std::string path_;
};

Expected<Pose> read_pose(const Fields& parent, std::string_view name) {
  ASSIGN_OR_RETURN(const Value* value, parent.get(name));
  ASSIGN_OR_RETURN(const Fields fields, Fields::of(*value, parent.path(name), {"position", "orientation"}));
  Pose pose;
  if (auto read = fields.numbers("position", pose.position, -kFarthest, kFarthest); !read)
    return tl::unexpected(read.error());
  if (auto read = fields.numbers("orientation", pose.orientation, -1.0, 1.0); !read)
    return tl::unexpected(read.error());
  double square = 0;
  for (const double component : pose.orientation) square += component * component;
  if (std::abs(square - 1.0) > 1e-3)
    return unexpected(ErrorCode::out_of_range, "expected a unit quaternion", fields.path("orientation"));
  for (double& component : pose.orientation) component /= std::sqrt(square);
  return pose;
}

Expected<Shape> read_shape(const Fields& parent) {
  ASSIGN_OR_RETURN(const Value* value, parent.get("shape"));
  const std::string path = parent.path("shape");
  ASSIGN_OR_RETURN(const Fields fields, Fields::of(*value, path, {"box", "cylinder", "sphere"}));
  if (value->as_dict().size() != 1) return unexpected(ErrorCode::type, "expected one of box, cylinder, sphere", path);
  const std::string& kind = value->as_dict().begin()->first.as_string();
  Shape shape;
  shape.kind = kind == "box" ? Shape::Kind::box : kind == "cylinder" ? Shape::Kind::cylinder : Shape::Kind::sphere;
  const std::size_t lengths = kind == "box" ? 3 : kind == "cylinder" ? 2 : 1;
  if (auto read = fields.numbers(kind, std::span(shape.size).first(lengths), 1e-3, kFarthest); !read)
    return tl::unexpected(read.error());
  return shape;
}

bool is_colour(const std::string& text) {
  return text.size() == 7 && text[0] == '#' && text.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string::npos;
}

Expected<Marker> read_marker(const Value& value, const std::string& path) {
  ASSIGN_OR_RETURN(const Fields fields, Fields::of(value, path, {"dictionary", "id", "side", "pose"}));
  Marker marker;
  ASSIGN_OR_RETURN(const std::string dictionary, fields.text("dictionary"));
  if (dictionary != services::kMarkerDictionary) {
    return unexpected(ErrorCode::unknown_name,
                      "the one known dictionary is " + std::string(services::kMarkerDictionary),
                      fields.path("dictionary"));
  }
  ASSIGN_OR_RETURN(const double id, fields.number("id", 0, services::kMarkerIds - 1));
  marker.id = static_cast<int>(id);
  if (marker.id != id) return unexpected(ErrorCode::type, "expected an int", fields.path("id"));
  ASSIGN_OR_RETURN(marker.side, fields.number("side", 1e-3, kFarthest));
  ASSIGN_OR_RETURN(marker.body_t_marker, read_pose(fields, "pose"));
  return marker;
}

Expected<std::vector<Marker>> read_markers(const Value& list, const std::string& path) {
  if (!list.is_list()) return unexpected(ErrorCode::type, "expected a list", path);
  std::vector<Marker> markers;
  for (const Value& each : list.as_list()) {
    ASSIGN_OR_RETURN(Marker marker, read_marker(each, path + "[" + std::to_string(markers.size()) + "]"));
    markers.push_back(marker);
  }
  return markers;
}

Expected<Body> read_body(const Value& value, const std::string& path) {
  ASSIGN_OR_RETURN(const Fields fields,
                   Fields::of(value, path, {"name", "shape", "pose", "mass", "friction", "colour", "markers"}));
  Body body;
  ASSIGN_OR_RETURN(body.name, fields.text("name"));
  ASSIGN_OR_RETURN(body.shape, read_shape(fields));
  ASSIGN_OR_RETURN(body.o_t_body, read_pose(fields, "pose"));
  ASSIGN_OR_RETURN(body.mass, fields.number("mass", 0, kHeaviest));
  ASSIGN_OR_RETURN(body.friction, fields.number("friction", 0, 10.0));
  ASSIGN_OR_RETURN(body.colour, fields.text("colour"));
  if (!is_colour(body.colour)) return unexpected(ErrorCode::type, "expected #rrggbb", fields.path("colour"));
  if (const Value* markers = value.find("markers")) {
    ASSIGN_OR_RETURN(body.markers, read_markers(*markers, fields.path("markers")));
  }
  return body;
}

Expected<Mounting> read_mounting(const Fields& parent) {
  ASSIGN_OR_RETURN(const Value* value, parent.get("robot"));
  ASSIGN_OR_RETURN(
      const Fields fields,
      Fields::of(*value, parent.path("robot"), {"urdf", "base", "q", "width", "finger_friction", "surface_friction"}));
  Mounting robot;
  ASSIGN_OR_RETURN(robot.urdf, fields.text("urdf"));
  ASSIGN_OR_RETURN(robot.o_t_base, read_pose(fields, "base"));
  if (auto read = fields.numbers("q", robot.q, -7.0, 7.0); !read) return tl::unexpected(read.error());
  ASSIGN_OR_RETURN(robot.width, fields.number("width", 0, 1.0));
  ASSIGN_OR_RETURN(robot.finger_friction, fields.number("finger_friction", 0, 10.0, robot.finger_friction));
  ASSIGN_OR_RETURN(robot.surface_friction, fields.number("surface_friction", 0, 10.0, robot.surface_friction));
  return robot;
}

Expected<CameraMount> read_camera(const Fields& parent, const Value& value) {
  ASSIGN_OR_RETURN(const Fields fields, Fields::of(value, parent.path("camera"), {"pose", "rate_hz"}));
  CameraMount camera;
  ASSIGN_OR_RETURN(camera.o_t_c, read_pose(fields, "pose"));
  ASSIGN_OR_RETURN(camera.rate_hz, fields.number("rate_hz", 0.1, 30.0, camera.rate_hz));
  return camera;
}

}  // namespace

Expected<Scene> read_scene(const Value& document) {
  ASSIGN_OR_RETURN(const Fields fields, Fields::of(document, "", {"scene", "name", "robot", "bodies", "camera"}));
  if (const Value* version = document.find("scene"); !version || *version != Value(1))
    return unexpected(ErrorCode::version, "expected scene version 1", "scene");
  Scene scene;
  ASSIGN_OR_RETURN(scene.name, fields.text("name"));
  ASSIGN_OR_RETURN(scene.robot, read_mounting(fields));
  ASSIGN_OR_RETURN(const Value* bodies, fields.get("bodies"));
  if (!bodies->is_list()) return unexpected(ErrorCode::type, "expected a list", "bodies");
  std::set<std::string> names;
  for (std::size_t i = 0; i < bodies->as_list().size(); ++i) {
    const std::string path = "bodies[" + std::to_string(i) + "]";
    ASSIGN_OR_RETURN(Body body, read_body(bodies->as_list()[i], path));
    if (!names.insert(body.name).second)
      return unexpected(ErrorCode::duplicate, "another body has the name '" + body.name + "'", path + ".name");
    scene.bodies.push_back(std::move(body));
  }
  if (const Value* camera = document.find("camera")) {
    ASSIGN_OR_RETURN(scene.camera, read_camera(fields, *camera));
  }
  return scene;
}

Expected<Scene> load_scene(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  if (!file || !(text << file.rdbuf())) return unexpected(ErrorCode::io, "cannot read the file", path);
  ASSIGN_OR_RETURN(const Value document, parse_json(text.str()));
  ASSIGN_OR_RETURN(Scene scene, read_scene(document));
  scene.robot.urdf = (std::filesystem::path(path).parent_path() / scene.robot.urdf).string();
  return scene;
}

}  // namespace race::world
