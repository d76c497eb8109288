#include "server/cell/world_check.h"

#include <algorithm>
#include <cctype>

#include "core/value/fields.h"
#include "server/cell/person_command.h"
#include "server/wire/pose_json.h"
#include "services/world/person.h"
#include "services/world/robot_model.h"

namespace race::server {
namespace {

using Need = Fields::Need;
constexpr std::size_t kBodies = 1000, kRobots = 8;
constexpr std::size_t kNameLength = 1000;  // bytes
constexpr std::size_t kTouches = world::Person::kHands + world::Person::kPushes;

bool is_positive(const Value& value) { return is_number(value) && value.to_double() > 0; }

bool is_vector(const Value& value) { return are_numbers(value, 3); }

bool is_shape(const Value& value) {
  if (!value.is_dict() || value.as_dict().size() != 1) return false;
  if (const Value* box = value.find("box"))
    return are_numbers(*box, 3) && std::ranges::all_of(box->as_list(), is_positive);
  if (const Value* sphere = value.find("sphere")) return is_positive(*sphere);
  const Value* cylinder = value.find("cylinder");
  if (!cylinder || !cylinder->is_dict() || cylinder->as_dict().size() != 2) return false;
  const Value* radius = cylinder->find("radius");
  const Value* length = cylinder->find("length");
  return radius && is_positive(*radius) && length && is_positive(*length);
}

bool is_colour(const Value& value) {
  if (!value.is_string()) return false;
  const std::string& text = value.as_string();
  return text.size() == 7 && text[0] == '#' &&
         std::all_of(text.begin() + 1, text.end(), [](unsigned char c) { return std::isxdigit(c); });
}

void need(Fields& fields, const char* name, bool (*fits)(const Value&), const char* what, Need need = Need::required) {
  const Value* value = fields.find(name, need);
  if (value && !fits(*value)) fields.violation(ErrorCode::type, std::string("must be ") + what, name);
}

/// A list of at most `most` objects, each read by `item`.
template <typename Item>
void items(Fields& fields, const char* name, std::size_t most, std::vector<Error>& errors, Item item) {
  const List& list = fields.list(name, Need::required);
  if (list.size() > most)
    return fields.violation(ErrorCode::out_of_range, "has at most " + std::to_string(most) + " items", name);
  for (std::size_t i = 0; i < list.size(); ++i) {
    Fields each(list[i], fields.path() + "/" + name + "/" + std::to_string(i), "the item", errors,
                Fields::Paths::field);
    item(each);
    each.close();
  }
}

Expected<void> first_of(const std::vector<Error>& errors) {
  if (!errors.empty()) return tl::unexpected(errors.front());
  return {};
}

void unique(Fields& fields, std::set<std::string>& names) {
  const auto name = fields.text("name", Need::required);
  if (name && name->size() > kNameLength) fields.violation(ErrorCode::out_of_range, "its name is too long", "name");
  if (name && !names.insert(*name).second) fields.violation(ErrorCode::duplicate, "there are two `" + *name + "`");
}

/// The names of the URDF files; parts become known.
std::set<std::string> check_scene(const Value& scene, WorldNames& known, std::vector<Error>& errors) {
  std::set<std::string> robots, bodies, files;
  Fields fields(scene, "world/scene", "the scene", errors, Fields::Paths::field);
  items(fields, "robots", kRobots, errors, [&](Fields& robot) {
    unique(robot, robots);
    files.insert(robot.text("urdf", Need::required).value_or(""));
    need(robot, "pose", is_pose, "a pose");
  });
  items(fields, "bodies", kBodies, errors, [&](Fields& body) {
    unique(body, bodies);
    need(body, "shape", is_shape, "a shape");
    need(body, "pose", is_pose, "a pose");
    need(
        body, "fixed", [](const Value& value) { return value.is_bool(); }, "a boolean");
    need(body, "colour", is_colour, "#rrggbb", Need::optional);
    need(body, "mass", is_number, "a number", Need::optional);
    const Value* fixed = body.find("fixed");
    if (const auto name = body.text("name"); name && fixed && fixed->is_bool() && !fixed->as_bool())
      known.parts.insert(*name);
  });
  fields.close();
  return files;
}

void check_hands(const WorldNames& world, Fields& fields, std::vector<Error>& errors) {
  items(fields, "hands", kTouches, errors, [&world](Fields& hand) {
    const auto name = hand.text("hand", Need::required), body = hand.text("body", Need::required);
    if (name && name->size() > kHandName * 4) hand.violation(ErrorCode::out_of_range, "its name is too long", "hand");
    if (body && !world.links.contains(*body) && !world.parts.contains(*body))
      hand.violation(ErrorCode::not_found, "there is no such link or part", "body");
    need(hand, "at", is_vector, "three numbers");
    need(hand, "force", is_vector, "three numbers");
    need(hand, "target", is_vector, "three numbers", Need::optional);
  });
}

}  // namespace

Expected<WorldNames> check_world(const Value& world) {
  WorldNames known;
  std::vector<Error> errors;
  Fields fields(world, "world", "the world", errors, Fields::Paths::field);
  const Value* scene = fields.find("scene", Need::required);
  const Value* files = fields.find("files", Need::required);
  fields.close();
  if (!errors.empty()) return tl::unexpected(errors.front());
  const std::set<std::string> names = check_scene(*scene, known, errors);
  if (!errors.empty()) return tl::unexpected(errors.front());
  if (!files->is_dict()) return unexpected(ErrorCode::type, "must be an object", "world/files");
  if (files->as_dict().size() != names.size())
    return unexpected(ErrorCode::unknown_field, "must be those that the scene names", "world/files");
  for (const std::string& name : names) {
    const std::string path = "world/files/" + name;
    const Value* text = files->find(name);
    if (!text) return unexpected(ErrorCode::missing, "the scene names it", path);
    if (!text->is_string()) return unexpected(ErrorCode::type, "must be a text", path);
    const auto urdf = world::read_urdf(text->as_string());
    if (!urdf) return unexpected(urdf.error().code, urdf.error().message, path);
    for (const world::Link& link : urdf->links) {
      known.links.insert(link.name);
      if (link.joint.kind != world::Joint::Kind::fixed) known.joints.insert(link.joint.name);
    }
  }
  return known;
}

Expected<void> check_pose(const WorldNames& world, const Value& pose) {
  std::vector<Error> errors;
  Fields fields(pose, "pose", "the pose", errors, Fields::Paths::field);
  need(fields, "time", is_number, "a number");
  const auto is_object = [](const Value& value) { return value.is_dict(); };
  need(fields, "joints", is_object, "an object");
  need(fields, "bodies", is_object, "an object");
  if (pose.find("hands")) check_hands(world, fields, errors);
  fields.close();
  if (!errors.empty()) return first_of(errors);
  for (const auto& [name, value] : pose.find("joints")->as_dict()) {
    const std::string path = "pose/joints/" + name.as_string();
    if (!world.joints.contains(name.as_string()))
      return unexpected(ErrorCode::not_found, "no robot has a joint of this name that moves", path);
    if (!is_number(value)) return unexpected(ErrorCode::type, "must be a number", path);
  }
  for (const auto& [name, value] : pose.find("bodies")->as_dict()) {
    const std::string path = "pose/bodies/" + name.as_string();
    if (!world.parts.contains(name.as_string()))
      return unexpected(ErrorCode::not_found, "the scene has no such part", path);
    if (!is_pose(value)) return unexpected(ErrorCode::type, "must be a pose", path);
  }
  return {};
}

Expected<void> check_person(const WorldNames& world, const Value& person) {
  std::vector<Error> errors;
  Fields fields(person, "person", "the answer", errors, Fields::Paths::field);
  check_hands(world, fields, errors);
  std::set<std::string> absent;
  for (const Value& part : fields.list("absent", Need::required)) {
    if (!part.is_string() || !world.parts.contains(part.as_string())) {
      fields.violation(ErrorCode::not_found, "the scene has no such part", "absent");
    } else if (!absent.insert(part.as_string()).second) {
      fields.violation(ErrorCode::duplicate, "a part is absent once", "absent");
    }
    if (!errors.empty()) break;
  }
  fields.close();
  return first_of(errors);
}

}  // namespace race::server
