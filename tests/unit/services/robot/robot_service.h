// The service `robot` on a real world, called as by a task.
#pragma once

#include <gmock/gmock.h>

#include <cmath>
#include <memory>
#include <string>
#include <string_view>

#include "services/robot/robot.h"
#include "tests/unit/services/robot/recorder.h"
#include "tests/unit/services/robot/rig.h"

namespace race::robot {

using services::CallId;

/// A robot on its world, as tasks call it; what it announces must fit its RSM.
struct RobotService : testing::Test {
  RobotService() { robot = std::move(Robot::create(host, *world).value()); }
  ~RobotService() override { EXPECT_THAT(host.violations, testing::IsEmpty()); }

  void run(double seconds) {
    for (int i = 0; i < static_cast<int>(std::lround(seconds * 1000)); ++i) {
      world->step();
      host.time = world->time();
      robot->step();
    }
  }
  CallId call(const std::string& operation, std::string_view arguments = "[]") {
    return host.call(*robot, operation, arguments);
  }
  void finish(CallId id) {
    for (int i = 0; i < 200 && !host.answered(id); ++i) run(0.1);
    ASSERT_TRUE(host.answered(id));
  }

  services::Recorder host{model()};
  std::unique_ptr<world::World> world = Rig::make_world(empty_scene());
  std::unique_ptr<Robot> robot;
};

}  // namespace race::robot
