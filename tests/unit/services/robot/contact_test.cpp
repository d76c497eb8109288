// Contacts and collisions: from external torques alone, then on the real world.
#include "services/robot/contact.h"

#include "tests/unit/services/robot/rig.h"

namespace race::robot {
namespace {

constexpr Joints kThresholds = {10, 10, 10, 10, 10, 10, 10};
constexpr double kDt = 0.001;

/// Feeds a torque of joint 3 that rises to `size` [Nm] within `seconds` and stays; all reports.
struct Told {
  std::vector<Contact> contacts, collisions;

  Told(ContactDetector& detector, double size, double seconds, double stays = 0.1) {
    for (double t = 0; t < seconds + stays; t += kDt) {
      const Touch touch = detector.update(Joints{0, 0, size * std::min(1.0, t / seconds)}, kDt);
      if (touch.contact) contacts.push_back(*touch.contact);
      if (touch.collision) collisions.push_back(*touch.collision);
    }
  }
};

TEST(ContactDetector, TellsOnceThatAContactBegins) {
  ContactDetector detector(kThresholds);
  EXPECT_TRUE(Told(detector, 9.9, 0.2).contacts.empty());
  const Told told(detector, 15, 0.2);
  ASSERT_EQ(told.contacts.size(), 1U);
  EXPECT_EQ(told.contacts[0].joint, 2U);
  EXPECT_TRUE(detector.touching());
}

TEST(ContactDetector, IsArmedAgainWhenTheContactHasEnded) {
  ContactDetector detector(kThresholds);
  EXPECT_EQ(Told(detector, 15, 0.2).contacts.size(), 1U);
  detector.update(Joints{0, 0, 7}, kDt);
  EXPECT_TRUE(detector.touching());
  detector.update(Joints{0, 0, 5}, kDt);
  EXPECT_FALSE(detector.touching());
  EXPECT_EQ(Told(detector, 15, 0.2).contacts.size(), 1U);
}

TEST(ContactDetector, TakesAFastOnsetForAccidentalAndASlowOneForIntended) {
  ContactDetector fast(kThresholds);
  const Told accident(fast, 15, 0.03);
  ASSERT_EQ(accident.collisions.size(), 1U);
  EXPECT_TRUE(accident.collisions[0].accidental);
  ContactDetector slow(kThresholds);
  const Told hand(slow, 15, 0.3);
  ASSERT_EQ(hand.contacts.size(), 1U);
  EXPECT_FALSE(hand.contacts[0].accidental);
  EXPECT_TRUE(hand.collisions.empty()) << "a light intended contact is no collision";
}

TEST(ContactDetector, ClassifiesSeverityByMultiplesOfTheThreshold) {
  ContactDetector detector(kThresholds);
  const Told told(detector, 80, 1.0);
  ASSERT_EQ(told.collisions.size(), 2U);
  EXPECT_EQ(told.contacts[0].severity, Severity::light);
  EXPECT_EQ(told.collisions[0].severity, Severity::medium);
  EXPECT_NEAR(told.collisions[0].torques[2], 10 * ContactDetector::kMedium, 1);
  EXPECT_EQ(told.collisions[1].severity, Severity::severe);
  EXPECT_NEAR(told.collisions[1].torques[2], 10 * ContactDetector::kSevere, 1);
}

TEST(ContactDetector, JudgesAnImpactByWhatTheResidualReachesNotByHowFastItRises) {
  ContactDetector detector(kThresholds);
  const Told told(detector, 10 * (ContactDetector::kMedium + 0.5), kDt / 2);
  ASSERT_EQ(told.collisions.size(), 1U);
  EXPECT_EQ(told.collisions[0].severity, Severity::medium);
}

/// Incidents with `signal` among those since the last call.
int count(ControlUnit& unit, Signal signal) {
  int count = 0;
  for (const Incident& incident : unit.take_incidents()) count += incident.signal == signal ? 1 : 0;
  return count;
}

TEST(Contact, IsToldOnceWhenTheToolMeetsTheTable) {
  Rig rig(demo_scene());
  ASSERT_FALSE(rig.move({.target = down_at(0.6, -0.32, 0.06)}));
  EXPECT_TRUE(rig.unit.take_incidents().empty());
  ASSERT_TRUE(rig.unit.move({.target = Offset{{0, 0, -0.1}}, .kind = MotionKind::linear, .speed = 0.05}));
  std::vector<Incident> incidents;
  for (int i = 0; i < 20000 && incidents.empty(); ++i) {
    rig.step();
    incidents = rig.unit.take_incidents();
  }
  ASSERT_EQ(incidents.size(), 2U) << "collision and contact";
  const Contact& contact = incidents[1].contact;
  const double force = wrench_at_tool(rig.unit.arm(), rig.world->q(), contact.torques).force[2];
  EXPECT_GT(force, 5) << "the table pushes upwards";
  EXPECT_LT(force, 40);
  EXPECT_EQ(rig.unit.arm().links()[contact.joint].substr(0, 5), "link_");
  rig.run(1);
  EXPECT_EQ(count(rig.unit, Signal::contact), 0);
  const double real =
      rig.world->contact_force("finger_left", "table") + rig.world->contact_force("finger_right", "table");
  EXPECT_NEAR(rig.unit.state().external.force[2], real, 0.1 * real + 0.5);
}

TEST(Contact, IsToldAgainAfterItEnded) {
  Rig rig(empty_scene());
  Vec3 force{0, 25, 0};
  rig.each_step = [&] { rig.world->push("gripper", force, rig.world->pose("tcp").position); };
  rig.run(0.5);
  EXPECT_EQ(count(rig.unit, Signal::contact), 1);
  rig.run(0.5);
  EXPECT_EQ(count(rig.unit, Signal::contact), 0);
  force = {};
  rig.run(0.5);
  force = {0, -25, 0};
  rig.run(0.5);
  EXPECT_EQ(count(rig.unit, Signal::contact), 1);
}

TEST(Contact, NamesTheLinkOrOneFartherIn) {
  Rig rig(empty_scene());
  rig.each_step = [&] {
    Vec3 elbow = rig.world->pose("link_4").position;
    rig.world->push("link_4", {0, 60, 0}, elbow);
  };
  rig.run(0.5);
  const auto incidents = rig.unit.take_incidents();
  ASSERT_FALSE(incidents.empty());
  EXPECT_LE(incidents[0].contact.joint, 3U);
}

TEST(Contact, OfAHandThatPushesGentlyIsIntended) {
  Rig rig(empty_scene());
  double force = 0;
  rig.each_step = [&] {
    force = std::min(25.0, force + 0.05);  // 50 N/s
    rig.world->push("gripper", {0, force, 0}, rig.world->pose("tcp").position);
  };
  rig.run(1);
  const auto incidents = rig.unit.take_incidents();
  ASSERT_EQ(incidents.size(), 1U);
  EXPECT_EQ(incidents[0].signal, Signal::contact);
  EXPECT_FALSE(incidents[0].contact.accidental);
}

}  // namespace
}  // namespace race::robot
