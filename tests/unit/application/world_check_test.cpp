// What a cell in a process says of its world is what a server takes; what is damaged is refused with its field.
#include "server/cell/world_check.h"

#include <gmock/gmock.h>

#include <array>
#include <limits>

#include "core/value/json.h"
#include "server/cell/inside_world.h"
#include "server/cell/person_act.h"

namespace race::server {
namespace {

using testing::HasSubstr;

struct WorldCheck : testing::Test {
  std::unique_ptr<InsideWorld> inside = InsideWorld::load(RACE_SOURCE_DIR "/deploy/demo/scene.json").value();
  const Value whole = inside->whole();

  Value person(const char* act) {
    const PersonAct read = read_person_act(parse_json(act).value(), kClientPatience).value();
    return inside->perform(read).value();
  }
};

std::string error(Expected<void> (*check)(const Value&, const Value&), const Value& world, const char* json) {
  const auto good = check(world, parse_json(json).value());
  return good ? "none" : to_string(good.error());
}

TEST_F(WorldCheck, WhatAnInsideWorldSaysFits) {
  EXPECT_TRUE(check_world(whole));
  EXPECT_TRUE(check_person(whole, inside->perform(std::nullopt).value()));
  const Value held = person(R"({"act": "grab", "body": "link_5"})");
  EXPECT_EQ(held.find("hands")->as_list().size(), 1U);
  EXPECT_TRUE(check_person(whole, held));
  const std::string part = inside->world().scene().bodies.back().name;
  EXPECT_TRUE(check_person(whole, person((R"({"act": "take", "part": ")" + part + "\"}").c_str())));
  inside->step();
  const Value pose = inside->pose(1.5);
  EXPECT_NE(pose.find("hands"), nullptr);
  EXPECT_TRUE(check_pose(whole, pose));
}

TEST_F(WorldCheck, WhatIsNoPoseOfThisWorldIsRefused) {
  EXPECT_EQ(error(check_pose, whole, R"({"time": 1, "joints": {}, "bodies": {}})"), "none");
  EXPECT_THAT(error(check_pose, whole, "[]"), HasSubstr("pose: type"));
  EXPECT_THAT(error(check_pose, whole, R"({"time": 1, "joints": {}})"), HasSubstr("missing"));
  EXPECT_THAT(error(check_pose, whole, R"({"time": 1, "joints": {"a": "b"}, "bodies": {}})"),
              HasSubstr("pose/joints/a: type"));
  EXPECT_THAT(error(check_pose, whole, R"({"time": 1, "joints": {}, "bodies": {"table": 1}})"),
              HasSubstr("pose/bodies/table: not_found"));
  std::string hands = R"({"hand": "h", "body": "b", "at": [0, 0, 0], "force": [0, 0, 0]})";
  EXPECT_EQ(error(check_person, whole, (R"({"absent": [], "hands": [)" + hands + "]}").c_str()), "none");
  const std::string one = hands;
  for (int i = 0; i < 24; ++i) hands += ", " + one;
  EXPECT_THAT(error(check_person, whole, (R"({"absent": [], "hands": [)" + hands + "]}").c_str()),
              HasSubstr("out_of_range"));
}

constexpr std::array kActs = {
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

// An act that goes to a process is the same act there.
TEST(WritePersonAct, WhatIsWrittenIsReadAsTheSameAct) {
  for (const char* json : kActs) {
    const Value before = parse_json(json).value();
    const Value written = write_person_act(read_person_act(before, kClientPatience).value());
    const auto again = read_person_act(written, std::numeric_limits<double>::infinity());
    ASSERT_TRUE(again) << to_json(written);
    EXPECT_EQ(write_person_act(*again), written);
    for (const auto& [name, value] : before.as_dict()) {
      const std::string field = name.as_string();
      if (field == "to") continue;  // a path of one point
      const Value* kept = written.find(field);
      ASSERT_NE(kept, nullptr) << field << " of " << to_json(written);
      EXPECT_EQ(to_json(*kept), to_json(value)) << field;
    }
  }
}

TEST(WritePersonAct, AHandThatStaysUntilItIsReleasedSaysNoKeep) {
  const double forever = std::numeric_limits<double>::infinity();
  const PersonAct act = read_person_act(parse_json(R"({"act": "drag", "to": [1, 2, 3]})").value(), forever).value();
  EXPECT_EQ(write_person_act(act).find("keep"), nullptr);
  EXPECT_EQ(read_person_act(write_person_act(act), forever).value().keep, forever);
}

}  // namespace
}  // namespace race::server
