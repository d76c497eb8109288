// What the eight components declare in their tables: each must be a service by the format and the constraints of RSM.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/rsm/document.h"
#include "core/rsm/rules.h"
#include "core/value/json.h"
#include "services/audio/audio.h"
#include "services/camera/camera.h"
#include "services/database/database.h"
#include "services/display/display.h"
#include "services/gripper/gripper.h"
#include "services/recognition/object_recognition.h"
#include "services/robot/robot.h"
#include "services/timer/timer.h"

namespace race::services {
namespace {

struct Declarations : testing::TestWithParam<const OperationTable*> {
  const rsm::Service& model() const { return GetParam()->model(); }
};

TEST_P(Declarations, AreServicesOfTheFormatAndItsConstraints) {
  const auto read = rsm::read_service(rsm::write_service(model()), model().name);
  ASSERT_TRUE(read.has_value()) << to_string(read.error().front());
  EXPECT_EQ(*read, model());
  EXPECT_FALSE(model().is_interface());
}

TEST_P(Declarations, AcceptEachOperationInSomeState) {
  for (const rsm::Operation& operation : model().operations)
    EXPECT_TRUE(std::ranges::any_of(model().states, [&](const rsm::ServiceState& state) {
      return rsm::taken_on(model(), {state.name, {}}, operation.name) != nullptr;
    })) << operation.name;
}

// Clients show the texts of an RSM to people, who do not have this repository.
TEST_P(Declarations, NameNoFileOfTheRepository) {
  EXPECT_EQ(to_json(rsm::write_service(model())).find(".md"), std::string::npos);
}

// A safe operation is called when a run faults: it must not be rejected.
TEST_P(Declarations, AcceptSafeOperationsInEveryState) {
  for (const rsm::Operation& operation : model().operations)
    for (const rsm::ServiceState& state : model().states)
      EXPECT_TRUE(!operation.safe || rsm::taken_on(model(), {state.name, {}}, operation.name))
          << operation.name << " in " << state.name;
}

TEST_P(Declarations, EndARefusedCallByATransitionThatAnswersIt) {
  for (const rsm::Transition& transition : model().transitions) {
    const std::string& refused = GetParam()->refused(transition.id);
    EXPECT_EQ(refused.empty(), transition.defer.empty()) << transition.id << ": only deferred calls need an answer";
    if (refused.empty()) continue;
    const rsm::Transition* answer = rsm::find_transition(model(), refused);
    ASSERT_NE(answer, nullptr) << transition.id;
    EXPECT_FALSE(answer->operation) << refused;
    EXPECT_TRUE(rsm::leaves_current(*answer, {transition.dst, {}})) << refused;
    EXPECT_EQ(std::ranges::count(transition.defer, refused), 1) << transition.id;
  }
}

INSTANTIATE_TEST_SUITE_P(Components, Declarations,
                         testing::Values(&audio::Audio::operations(), &camera::Camera::operations(),
                                         &database::Database::operations(), &display::Display::operations(),
                                         &gripper::Gripper::operations(), &recognition::ObjectRecognition::operations(),
                                         &robot::Robot::operations(), &timer::Timer::operations()),
                         [](const auto& each) { return each.param->model().name; });

}  // namespace
}  // namespace race::services
