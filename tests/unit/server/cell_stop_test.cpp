#include "server/control/cell_stop.h"

#include <gmock/gmock.h>

#include <thread>

#include "core/rsm/document.h"
#include "tests/unit/server/running_cores.h"

namespace race::server {
namespace {

using testing::ElementsAre;

// Keeps what is called.
class Winch final : public services::Component {
 public:
  explicit Winch(services::ServiceHost& host) : host_(host) {}
  const rsm::Service& model() const override {
    static const rsm::Service model = rsm::read_service_text(R"json({
      "rsm": 1, "name": "winch", "operations": [{"name": "brake", "safe": true}], "events": [],
      "states": [{"name": "Here"}], "init": "Here",
      "transitions": [{"id": "brake", "dst": "Here", "operation": "brake"}]})json",
                                                             "services/winch")
                                          .value();
    return model;
  }
  void call(const services::Call& call) override {
    calls.push_back(call.operation);
    host_.transition(call.operation, call.id);
    host_.result(call.id, nullptr);
  }
  std::vector<std::string> calls;

 private:
  services::ServiceHost& host_;
};

struct CellStopTest : RunningCores {
  CellStopTest() {
    auto made = std::make_unique<Winch>(host.declare("winch", "winch", queue));
    winch = made.get();
    host.attach("winch", std::move(made));
  }
  services::WorkQueue queue;
  Winch* winch = nullptr;
  TemporaryFolder folder;
  Control control{[](const Value&) {}};
  CellStop cell_stop{
      control, host, cores, {StopMark(folder.file("stopped")), ModeMark(folder.file("mode"))}, [](auto&) {}};
};

TEST_F(CellStopTest, ASecondPressCallsAgainWhateverTheClockOfTheMachineSays) {
  cell_stop.stop("alice", 1'000'000);
  std::this_thread::sleep_for(std::chrono::milliseconds(110));
  cell_stop.stop("alice", 5);  // the clock was set back meanwhile
  queue.run();
  EXPECT_THAT(winch->calls, ElementsAre("brake", "brake"));
}

TEST_F(CellStopTest, AFloodOfPressesCallsOnce) {
  for (std::int64_t now = 1'000'000; now < 1'010'000; now += 1000) cell_stop.stop("alice", now);
  queue.run();
  EXPECT_THAT(winch->calls, ElementsAre("brake"));
}

}  // namespace
}  // namespace race::server
