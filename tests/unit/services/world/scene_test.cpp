// Validation of scene files: what it takes, and how it names what it refuses.
#include "services/world/scene.h"

#include <gtest/gtest.h>

#include "core/value/json.h"

namespace race::world {
namespace {

Value demo() {
  return parse_json(R"({
    "scene": 1, "name": "test",
    "robot": {"urdf": "arm.urdf", "base": {"position": [0, 0, 0], "orientation": [0, 0, 0, 1]},
              "q": [0, 0, 0, 0, 0, 0, 0], "width": 0.1},
    "camera": {"pose": {"position": [1, 0, 1], "orientation": [1, 0, 0, 0]}, "rate_hz": 10},
    "bodies": [{"name": "ball", "shape": {"sphere": [0.02]}, "mass": 0.1, "friction": 0.5, "colour": "#12Ab34",
                "pose": {"position": [0.5, 0, 0.02], "orientation": [0, 0, 0, 1]},
                "markers": [{"dictionary": "DICT_4X4_50", "id": 7, "side": 0.03,
                             "pose": {"position": [0, 0, 0.02], "orientation": [0, 0, 0, 1]}}]}]})")
      .value();
}

/// The demo with the value at `keys` (names, or indices of lists) replaced, or removed if it is unknown.
Value changed(Value document, const std::vector<std::string>& keys, const Value& value) {
  Value* place = &document;
  const auto last = std::prev(keys.end());
  for (auto key = keys.begin(); key != last; ++key) {
    place = place->is_list() ? &place->mutable_list()[static_cast<std::size_t>(std::stoi(*key))]
                             : place->mutable_dict().find(Value(*key));
  }
  if (value.is_unknown()) {
    place->mutable_dict().erase(*last);
  } else if (place->is_list()) {
    place->mutable_list()[static_cast<std::size_t>(std::stoi(*last))] = value;
  } else {
    place->mutable_dict().set(*last, value);
  }
  return document;
}

TEST(Scene, IsReadWithItsBodies) {
  const auto scene = read_scene(demo());
  ASSERT_TRUE(scene) << to_string(scene.error());
  ASSERT_EQ(scene->bodies.size(), 1U);
  EXPECT_EQ(scene->bodies[0].shape, (Shape{Shape::Kind::sphere, {0.02, 0, 0}}));
  EXPECT_EQ(scene->bodies[0].o_t_body.position, (Vec3{0.5, 0, 0.02}));
  ASSERT_EQ(scene->bodies[0].markers.size(), 1U);
  EXPECT_EQ(scene->bodies[0].markers[0].id, 7);
  EXPECT_EQ(scene->bodies[0].markers[0].side, 0.03);
  EXPECT_EQ(scene->bodies[0].markers[0].body_t_marker.position, (Vec3{0, 0, 0.02}));
  EXPECT_EQ(scene->robot.finger_friction, 1.0);
  ASSERT_TRUE(scene->camera);
  EXPECT_EQ(scene->camera->o_t_c.position, (Vec3{1, 0, 1}));
  EXPECT_EQ(scene->camera->rate_hz, 10.0);
}

TEST(Scene, NeedsNoCamera) {
  const auto scene = read_scene(changed(demo(), {"camera"}, Value::unknown()));
  ASSERT_TRUE(scene) << to_string(scene.error());
  EXPECT_FALSE(scene->camera);
}

struct Broken {
  std::vector<std::string> keys;
  Value value;
  ErrorCode code;
  const char* path;
};

std::vector<std::string> marker(const std::string& field) { return {"bodies", "0", "markers", "0", field}; }

TEST(Scene, NamesWhatItRefuses) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Broken> cases = {
      {{"scene"}, 2, ErrorCode::version, "scene"},
      {{"name"}, Value::unknown(), ErrorCode::missing, "name"},
      {{"colour"}, "red", ErrorCode::unknown_field, ".colour"},
      {{"robot"}, List{}, ErrorCode::type, "robot"},
      {{"robot", "urdf"}, "", ErrorCode::type, "robot.urdf"},
      {{"robot", "q"}, List{Value(0)}, ErrorCode::type, "robot.q"},
      {{"robot", "q", "3"}, 9.0, ErrorCode::out_of_range, "robot.q[3]"},
      {{"robot", "width"}, -0.1, ErrorCode::out_of_range, "robot.width"},
      {{"robot", "base", "orientation", "3"}, 0.5, ErrorCode::out_of_range, "robot.base.orientation"},
      {{"camera", "rate_hz"}, 31, ErrorCode::out_of_range, "camera.rate_hz"},
      {{"camera", "pose"}, Value::unknown(), ErrorCode::missing, "camera.pose"},
      {{"camera", "fov"}, 1, ErrorCode::unknown_field, "camera.fov"},
      {{"bodies"}, Value(), ErrorCode::type, "bodies"},
      {{"bodies", "0", "name"}, 3, ErrorCode::type, "bodies[0].name"},
      {{"bodies", "0", "mass"}, -1, ErrorCode::out_of_range, "bodies[0].mass"},
      {{"bodies", "0", "mass"}, nan, ErrorCode::out_of_range, "bodies[0].mass"},
      {{"bodies", "0", "mass"}, "1 kg", ErrorCode::type, "bodies[0].mass"},
      {{"bodies", "0", "friction"}, Value::unknown(), ErrorCode::missing, "bodies[0].friction"},
      {{"bodies", "0", "colour"}, "#12345g", ErrorCode::type, "bodies[0].colour"},
      {{"bodies", "0", "shape"}, Dict{{"cone", List{}}}, ErrorCode::unknown_field, "bodies[0].shape.cone"},
      {{"bodies", "0", "shape"}, Dict{}, ErrorCode::type, "bodies[0].shape"},
      {{"bodies", "0", "shape", "sphere", "0"}, 0, ErrorCode::out_of_range, "bodies[0].shape.sphere[0]"},
      {{"bodies", "0", "pose", "position"}, "here", ErrorCode::type, "bodies[0].pose.position"},
      {{"bodies", "0", "markers"}, Dict{}, ErrorCode::type, "bodies[0].markers"},
      {{"bodies", "0", "markers", "0"}, 7, ErrorCode::type, "bodies[0].markers[0]"},
      {marker("dictionary"), "DICT_5X5_50", ErrorCode::unknown_name, "bodies[0].markers[0].dictionary"},
      {marker("dictionary"), Value::unknown(), ErrorCode::missing, "bodies[0].markers[0].dictionary"},
      {marker("id"), 50, ErrorCode::out_of_range, "bodies[0].markers[0].id"},
      {marker("id"), -1, ErrorCode::out_of_range, "bodies[0].markers[0].id"},
      {marker("id"), 1.5, ErrorCode::type, "bodies[0].markers[0].id"},
      {marker("id"), nan, ErrorCode::out_of_range, "bodies[0].markers[0].id"},
      {marker("side"), 0, ErrorCode::out_of_range, "bodies[0].markers[0].side"},
      {marker("side"), -0.03, ErrorCode::out_of_range, "bodies[0].markers[0].side"},
      {marker("side"), nan, ErrorCode::out_of_range, "bodies[0].markers[0].side"},
      {marker("pose"), Value::unknown(), ErrorCode::missing, "bodies[0].markers[0].pose"},
      {marker("colour"), "black", ErrorCode::unknown_field, "bodies[0].markers[0].colour"},
  };
  for (const Broken& broken : cases) {
    const auto scene = read_scene(changed(demo(), broken.keys, broken.value));
    ASSERT_FALSE(scene) << broken.path;
    EXPECT_EQ(name(scene.error().code), name(broken.code)) << broken.path;
    EXPECT_EQ(scene.error().path, broken.path);
  }
}

TEST(Scene, RefusesTwoBodiesOfOneName) {
  Value document = demo();
  List& bodies = document.mutable_dict().find(Value("bodies"))->mutable_list();
  bodies.push_back(bodies.front());
  const auto scene = read_scene(document);
  ASSERT_FALSE(scene);
  EXPECT_EQ(scene.error().code, ErrorCode::duplicate);
  EXPECT_EQ(scene.error().path, "bodies[1].name");
}

TEST(Scene, OfTheDemonstratorIsReadable) {
  const auto scene = load_scene(RACE_SOURCE_DIR "/deploy/demo/scene.json");
  ASSERT_TRUE(scene) << to_string(scene.error());
  EXPECT_TRUE(load_urdf(scene->robot.urdf));
  EXPECT_EQ(load_scene("/nowhere/scene.json").error().code, ErrorCode::io);
}

}  // namespace
}  // namespace race::world
