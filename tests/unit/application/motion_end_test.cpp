// The end of a server waits until what moves stands, also what moves while a person holds a button.
#include "server/application/motion_end.h"

#include <gmock/gmock.h>

#include <future>

#include "core/rsm/document.h"
#include "tests/unit/server/running_cores.h"

namespace race::server {
namespace {

using namespace std::chrono_literals;

// A jog is answered at once, and goes on.
class Arm final : public services::Component {
 public:
  Arm(services::ServiceHost& host, std::vector<std::string>& calls) : host_(host), calls_(calls) {}
  const rsm::Service& model() const override {
    static const rsm::Service model = rsm::read_service_text(R"json({
      "rsm": 1, "name": "arm", "states": [{"name": "Here"}], "init": "Here", "events": [],
      "operations": [{"name": "jog", "held": true, "moves": true}, {"name": "look", "reads": true},
                     {"name": "stop", "safe": true}],
      "transitions": [{"id": "jog", "dst": "Here", "operation": "jog"}, {"id": "look", "dst": "Here", "operation": "look"},
                      {"id": "stop", "dst": "Here", "operation": "stop"}]})json",
                                                             "services/arm")
                                          .value();
    return model;
  }
  void call(const services::Call& call) override {
    calls_.push_back(call.operation);
    host_.transition(call.operation, call.id);
    host_.result(call.id, nullptr);
  }

 private:
  services::ServiceHost& host_;
  std::vector<std::string>& calls_;
};

struct MotionEndTest : RunningCores {
  MotionEndTest() { gated.attach("arm", std::make_unique<Arm>(gated.declare("arm", "arm", queue), calls)); }
  ~MotionEndTest() override { end.finish(); }
  void call(const char* operation) {
    gated.call({"control/1", 1, 0}, "arm", operation, {}, {});
    queue.run();
  }
  /// How long the end takes.
  std::chrono::steady_clock::duration ends() {
    const auto begun = std::chrono::steady_clock::now();
    std::promise<void> done;
    end.begin_end(gated, cores, [&] { done.set_value(); });
    auto over = done.get_future();
    while (over.wait_for(1ms) != std::future_status::ready) queue.run();
    return std::chrono::steady_clock::now() - begun;
  }

  std::vector<std::string> calls;
  services::OpenGate open;
  MotionEnd end{open};
  NoObserver nobody;
  services::WorldClock time;
  services::WorkQueue queue;
  services::Host gated{time, nobody, &end};
};

TEST_F(MotionEndTest, WhatIsHeldIsStoppedAndHasTimeToStandThoughItsCallWasAnswered) {
  call("jog");
  EXPECT_GE(ends(), MotionEnd::kArrival + MotionEnd::kBraking);
  EXPECT_THAT(calls, testing::ElementsAre("jog", "stop"));
  call("jog");
  EXPECT_THAT(calls, testing::ElementsAre("jog", "stop")) << "nothing moves any more";
}

TEST_F(MotionEndTest, WhereNothingMovesNothingIsWaitedFor) {
  call("look");
  EXPECT_LT(ends(), MotionEnd::kArrival + MotionEnd::kBraking);
  EXPECT_THAT(calls, testing::ElementsAre("look", "stop"));
}

}  // namespace
}  // namespace race::server
