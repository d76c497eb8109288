// Validation of URDF files.
#include "services/world/robot_model.h"

#include <gtest/gtest.h>

namespace race::world {
namespace {

const std::string kLink2 =
    R"(<inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>
  <collision><geometry><sphere radius="0.1"/></geometry></collision>)";
const std::string kLimit = R"(<limit lower="-1" upper="1" effort="10" velocity="2"/>)";

std::string urdf(const std::string& link, const std::string& limit, const std::string& type = "revolute") {
  return R"(<robot name="r"><link name="a"/><link name="b">)" + link + R"(</link><joint name="j" type=")" + type +
         R"("><parent link="a"/><child link="b"/><origin xyz="0 0 1"/><axis xyz="0 2 0"/>)" + limit +
         "</joint></robot>";
}

// Links a, b, c and d with fixed joints between these.
std::string chain(const std::vector<std::pair<std::string, std::string>>& joints) {
  std::string text = R"(<robot name="r"><link name="a"/><link name="b"/><link name="c"/><link name="d"/>)";
  for (const auto& [parent, child] : joints)
    text += "<joint name=\"" + parent + child + R"(" type="fixed"><parent link=")" + parent + R"("/><child link=")" +
            child + "\"/></joint>";
  return text + "</robot>";
}

TEST(RobotModel, ReadsLinksJointsAndInertias) {
  const auto model = read_urdf(urdf(kLink2, kLimit));
  ASSERT_TRUE(model) << to_string(model.error());
  ASSERT_EQ(model->links.size(), 2U);
  const Link& link = model->links[1];
  EXPECT_EQ(link.parent, 0);
  EXPECT_EQ(link.joint.kind, Joint::Kind::revolute);
  EXPECT_EQ(link.joint.axis, (Vec3{0, 1, 0}));
  EXPECT_EQ(link.joint.parent_t_joint.position, (Vec3{0, 0, 1}));
  EXPECT_EQ(link.joint.upper, 1);
  EXPECT_EQ(link.mass, 1);
  EXPECT_EQ(link.collisions.at(0).shape.kind, Shape::Kind::sphere);
  EXPECT_EQ(model->link("b"), 1);
  EXPECT_EQ(model->link("c"), -1);
}

TEST(RobotModel, ReadsWhatIsSeenOfALink) {
  const std::string text =
      R"(<robot name="r"><material name="orange"><color rgba="1 0.5 0 1"/></material><link name="a">
    <visual><origin xyz="0 0 1"/><geometry><box size="1 2 3"/></geometry><material name="orange"/></visual>
    <visual><geometry><sphere radius="0.1"/></geometry><material name="own"><color rgba="0 0 1 1"/></material></visual>
    <visual><geometry><cylinder radius="0.1" length="0.2"/></geometry></visual></link></robot>)";
  const auto model = read_urdf(text);
  ASSERT_TRUE(model) << to_string(model.error());
  const auto& visuals = model->links[0].visuals;
  ASSERT_EQ(visuals.size(), 3U);
  EXPECT_EQ(visuals[0].shape, (Shape{Shape::Kind::box, {1, 2, 3}}));
  EXPECT_EQ(visuals[0].link_t_shape.position, (Vec3{0, 0, 1}));
  EXPECT_EQ(visuals[0].colour, "#ff8000") << "by the name of the robot's material";
  EXPECT_EQ(visuals[1].colour, "#0000ff");
  EXPECT_EQ(visuals[2].colour, "#808080") << "without a material";
}

TEST(RobotModel, NamesWhatItRefuses) {
  struct Broken {
    std::string text;
    ErrorCode code;
  };
  const std::string tilted = R"(<inertial><origin rpy="0.1 0 0"/><mass value="1"/>
    <inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>)";
  const std::string massless =
      R"(<inertial><mass value="0"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>)";
  const std::string mesh = kLink2.substr(0, kLink2.find("<collision>")) +
                           R"(<collision><geometry><mesh filename="a.stl"/></geometry></collision>)";
  const std::vector<Broken> cases = {
      {"", ErrorCode::syntax},
      {"<robot", ErrorCode::syntax},
      {urdf("", kLimit), ErrorCode::missing},
      {urdf(tilted, kLimit), ErrorCode::type},
      {urdf(massless, kLimit), ErrorCode::out_of_range},
      {urdf(mesh, kLimit), ErrorCode::type},
      {urdf(kLink2, R"(<limit lower="1" upper="-1" effort="10" velocity="2"/>)"), ErrorCode::out_of_range},
      {urdf(kLink2, R"(<limit lower="-1" upper="1" effort="0" velocity="2"/>)"), ErrorCode::out_of_range},
      {urdf(kLink2, "", "continuous"), ErrorCode::type},
      {R"(<robot name="r"><link name="a"/><link name="b"/><joint name="j" type="fixed"><parent link="a"/><child link="b"/>
        </joint><joint name="k" type="fixed"><parent link="a"/><child link="b"/></joint></robot>)",
       ErrorCode::duplicate},
      {chain({{"a", "b"}, {"c", "c"}}), ErrorCode::conflict},
      {chain({{"a", "b"}, {"c", "d"}, {"d", "c"}}), ErrorCode::conflict},
      {chain({{"a", "b"}, {"b", "a"}}), ErrorCode::conflict},
  };
  for (const Broken& broken : cases) {
    const auto model = read_urdf(broken.text);
    ASSERT_FALSE(model) << broken.text;
    EXPECT_EQ(name(model.error().code), name(broken.code)) << broken.text;
  }
  EXPECT_EQ(load_urdf("/nowhere/arm.urdf").error().code, ErrorCode::io);
}

}  // namespace
}  // namespace race::world
