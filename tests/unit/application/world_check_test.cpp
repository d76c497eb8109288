// What a cell in a process says of its world is what a server takes; what is damaged is refused with its field.
#include "server/cell/world_check.h"

#include <gmock/gmock.h>

#include <array>
#include <limits>

#include "core/value/json.h"
#include "server/cell/local_world.h"
#include "server/cell/person_command.h"

namespace race::server {
namespace {

using testing::HasSubstr;

struct WorldCheck : testing::Test {
  std::unique_ptr<LocalWorld> local_world = LocalWorld::load(RACE_SOURCE_DIR "/deploy/demo/scene.json").value();
  const Value whole = local_world->description();
  const WorldNames names = check_world(whole).value();

  Value person(const char* act) {
    const PersonCommand read = read_person_command(parse_json(act).value(), kClientKeep).value();
    return local_world->perform(read).value();
  }
};

std::string error(Expected<void> (*check)(const WorldNames&, const Value&), const WorldNames& world,
                  const std::string& json) {
  const auto good = check(world, parse_json(json).value());
  return good ? "none" : to_string(good.error());
}

TEST_F(WorldCheck, WhatALocalWorldSaysFits) {
  EXPECT_TRUE(check_person(names, local_world->perform(std::nullopt).value()));
  const Value held = person(R"({"act": "grab", "body": "link_5"})");
  EXPECT_EQ(held.find("hands")->as_list().size(), 1U);
  EXPECT_TRUE(check_person(names, held));
  const std::string part = local_world->world().scene().bodies.back().name;
  EXPECT_TRUE(check_person(names, person((R"({"act": "take", "part": ")" + part + "\"}").c_str())));
  local_world->step();
  const Value pose = local_world->pose(1.5);
  EXPECT_NE(pose.find("hands"), nullptr);
  EXPECT_TRUE(check_pose(names, pose));
}

TEST_F(WorldCheck, WhatIsNoPoseOfThisWorldIsRefused) {
  EXPECT_EQ(error(check_pose, names, R"({"time": 1, "joints": {}, "bodies": {}})"), "none");
  EXPECT_THAT(error(check_pose, names, "[]"), HasSubstr("pose: type"));
  EXPECT_THAT(error(check_pose, names, R"({"time": 1, "joints": {}})"), HasSubstr("missing"));
  EXPECT_THAT(error(check_pose, names, R"({"time": 1, "joints": {"a": 1}, "bodies": {}})"),
              HasSubstr("pose/joints/a: not_found"));
  const std::string joint = *names.joints.begin(), part = *names.parts.begin();
  EXPECT_THAT(error(check_pose, names, R"({"time": 1, "joints": {")" + joint + R"(": "b"}, "bodies": {}})"),
              HasSubstr("pose/joints/" + joint + ": type"));
  const auto turned = [&](const char* orientation) {
    return R"({"time": 1, "joints": {}, "bodies": {")" + part + R"(": {"position": [0, 0, 1], "orientation": )" +
           orientation + "}}}";
  };
  EXPECT_EQ(error(check_pose, names, turned("[0, 0.6, 0, 0.8]")), "none");
  for (const char* none : {"[0, 0, 0, 0]", "[0, 0, 0, 2]", "[0, 0, 1e200, 0]"})
    EXPECT_THAT(error(check_pose, names, turned(none)), HasSubstr("pose/bodies/" + part + ": type"));
  EXPECT_THAT(error(check_pose, names, R"({"time": 1, "joints": {}, "bodies": {"table": 1}})"),
              HasSubstr("pose/bodies/table: not_found"));
  std::string hands = R"({"hand": "h", "body": "link_5", "at": [0, 0, 0], "force": [0, 0, 0]})";
  EXPECT_EQ(error(check_person, names, (R"({"absent": [], "hands": [)" + hands + "]}").c_str()), "none");
  const std::string one = hands;
  for (int i = 0; i < 24; ++i) hands += ", " + one;
  EXPECT_THAT(error(check_person, names, (R"({"absent": [], "hands": [)" + hands + "]}").c_str()),
              HasSubstr("out_of_range"));
  const auto hand = [&](const std::string& name, const std::string& body) {
    return error(check_person, names,
                 R"({"absent": [], "hands": [{"hand": ")" + name + R"(", "body": ")" + body +
                     R"(", "at": [0, 0, 0], "force": [0, 0, 0]}]})");
  };
  EXPECT_EQ(hand("h", part), "none");
  EXPECT_THAT(hand("h", "table"), HasSubstr("hands/0/body: not_found"));
  EXPECT_THAT(hand("h", "link_99"), HasSubstr("hands/0/body: not_found"));
  EXPECT_THAT(hand(std::string(10000, 'h'), part), HasSubstr("hands/0/hand: out_of_range"));
  EXPECT_EQ(error(check_person, names, R"({"hands": [], "absent": [")" + part + "\"]}"), "none");
  EXPECT_THAT(error(check_person, names, R"({"hands": [], "absent": [")" + part + R"(", ")" + part + "\"]}"),
              HasSubstr("absent: duplicate"));
}

constexpr std::array kPendingCommands = {
    R"({"act": "grab", "hand": "left", "body": "link_5", "point": [0.0, 0.0, 0.5], "stiffness": 20.0, "damping": 1.0, )"
    R"("limit": 9.0, "keep": 7.0})",
    R"({"act": "grab", "body": "link_5"})",
    R"({"act": "drag", "by": [1.0, 2.0, 3.0], "speed": 0.5})",
    R"({"act": "drag", "to": [1.0, 2.0, 3.0]})",
    R"({"act": "drag", "path": [[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]], "keep": 0.0})",
    R"({"act": "release", "hand": "left"})",
    R"({"act": "push", "body": "b", "force": [1.0, 2.0, 3.0], "point": [0.0, 0.0, 1.0], "duration": 2.0, "rise": 0.5})",
    R"({"act": "place", "part": "p", "pose": {"position": [1.0, 2.0, 3.0], "orientation": [0.0, 0.0, 0.6, 0.8]}})",
    R"({"act": "place", "part": "p"})",
    R"({"act": "take", "part": "p"})"};

// A command that goes to a process is the same command there.
TEST(WritePersonCommand, WhatIsWrittenIsReadAsTheSameCommand) {
  for (const char* json : kPendingCommands) {
    const Value before = parse_json(json).value();
    const Value written = write_person_command(read_person_command(before, kClientKeep).value());
    const auto again = read_person_command(written, std::numeric_limits<double>::infinity());
    ASSERT_TRUE(again) << to_json(written);
    EXPECT_EQ(write_person_command(*again), written);
    for (const auto& [name, value] : before.as_dict()) {
      const std::string field = name.as_string();
      if (field == "to") continue;  // a path of one point
      const Value* kept = written.find(field);
      ASSERT_NE(kept, nullptr) << field << " of " << to_json(written);
      EXPECT_EQ(to_json(*kept), to_json(value)) << field;
    }
  }
}

TEST(WritePersonCommand, AHandThatStaysUntilItIsReleasedSaysNoKeep) {
  const double forever = std::numeric_limits<double>::infinity();
  const PersonCommand act =
      read_person_command(parse_json(R"({"act": "drag", "to": [1, 2, 3]})").value(), forever).value();
  EXPECT_EQ(write_person_command(act).find("keep"), nullptr);
  EXPECT_EQ(read_person_command(write_person_command(act), forever).value().keep, forever);
}

}  // namespace
}  // namespace race::server
