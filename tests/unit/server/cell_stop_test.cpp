#include "server/control/cell_stop.h"

#include <gmock/gmock.h>

#include <array>
#include <atomic>
#include <barrier>
#include <future>
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
  void limit_speed(std::optional<double> tool_speed) override { limit = tool_speed; }
  std::vector<std::string> calls;
  std::optional<double> limit;

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
  std::vector<std::string> lines;  // of the log: of one thread, until the end
  Control control{[](const Value&) {}};
  CellStop cell_stop{control,
                     host,
                     cores,
                     {StopMark(folder.file("stopped")), ModeMark(folder.file("mode"))},
                     [this](const std::string& line) { lines.push_back(line); }};
};

TEST_F(CellStopTest, ASecondPressCallsAgainWhateverTheClockOfTheMachineSays) {
  cell_stop.stop("alice", 1'000'000);
  std::this_thread::sleep_for(std::chrono::milliseconds(110));
  cell_stop.stop("alice", 5);  // the clock was set back meanwhile
  queue.run();
  EXPECT_THAT(winch->calls, ElementsAre("brake", "brake"));
}

TEST_F(CellStopTest, AResetOfACellThatIsNotStoppedIsNone) {
  EXPECT_FALSE(cell_stop.reset("alice"));
  cell_stop.stop("alice", 1);
  EXPECT_TRUE(cell_stop.reset("alice"));
  EXPECT_FALSE(cell_stop.reset("bob")) << "asked for again";
  cell_stop.end();
  EXPECT_EQ(lines, (std::vector<std::string>{"stopped by alice", "reset by alice"}));
}

TEST_F(CellStopTest, AFloodOfPressesCallsOnce) {
  for (std::int64_t now = 1'000'000; now < 1'010'000; now += 1000) cell_stop.stop("alice", now);
  queue.run();
  EXPECT_THAT(winch->calls, ElementsAre("brake"));
}

// What lies between the limit and the mode is held by the test that follows: no number of rounds is sure to hit it.
TEST_F(CellStopTest, TheMarkIsOfTheModeThatHoldsWhoeverSetsItAtOnce) {
  const std::uint64_t number = *control.take("alice", std::chrono::steady_clock::now());
  constexpr int kRounds = 500;
  std::barrier begun(3);
  const auto toggle = [&](Mode mode) {
    return std::thread([this, &begun, number, mode] {
      for (int round = 0; round < kRounds; ++round) {
        begun.arrive_and_wait();
        EXPECT_TRUE(cell_stop.set_mode(number, mode));
        begun.arrive_and_wait();
      }
    });
  };
  std::array<std::thread, 2> people{toggle(Mode::programming), toggle(Mode::execution)};
  for (int round = 0; round < kRounds; ++round) {
    begun.arrive_and_wait();
    begun.arrive_and_wait();
    queue.run();
  }
  for (std::thread& person : people) person.join();
  cell_stop.end();
  const bool is_slow = control.mode() == Mode::programming;
  EXPECT_EQ(winch->limit, is_slow ? std::optional(kReducedSpeed) : std::nullopt);
  EXPECT_EQ(ModeMark(folder.file("mode")).read(), control.mode());
}

// Keeps the host busy from its first word on, until it may go on.
struct Busy final : services::HostObserver {
  void delivered(const services::Delivery&) override {
    begun.set_value();
    go_on.get_future().wait();
  }
  void changed(const services::ServiceStatus&) override {}
  void logged(services::Time, const std::string&, const std::string&) override {}
  std::promise<void> begun, go_on;
};

TEST_F(CellStopTest, NoOtherModeBeginsUntilTheLimitIsThatOfTheOneBefore) {
  for (const Mode first : {Mode::programming, Mode::execution}) {
    const Mode before = first == Mode::programming ? Mode::execution : Mode::programming;
    std::atomic<int> told{0};
    Control people{[&](const Value&) { ++told; }};
    people.set_mode(before);
    const std::uint64_t number = *people.take("alice", std::chrono::steady_clock::now());
    Busy busy;
    services::Host slow(clock, busy);
    CellStop stops{people, slow, cores, {StopMark(folder.file("no")), ModeMark(folder.file("other"))}, [](auto&) {}};
    people.set_mode(before);  // whatever the file says
    std::thread talk([&] { slow.call({"core", 1}, "nobody", "go", {}, {}); });
    busy.begun.get_future().wait();
    told = 0;
    std::thread one([&] { EXPECT_TRUE(stops.set_mode(number, first)); });
    const int at_once = first == Mode::programming ? 0 : 1;
    while (told < at_once) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    EXPECT_EQ(people.mode(), Mode::execution) << "not before the robots are slow";
    std::thread other([&] { EXPECT_TRUE(stops.set_mode(number, before)); });
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    EXPECT_EQ(told, at_once);
    busy.go_on.set_value();
    for (std::thread* each : {&talk, &one, &other}) each->join();
    EXPECT_EQ(people.mode(), before);
  }
}

TEST_F(CellStopTest, WhoHasNotTheControlsChangesNoLimit) {
  const std::uint64_t number = *control.take("alice", std::chrono::steady_clock::now());
  EXPECT_EQ(cell_stop.set_mode(number + 1, Mode::programming).error().code, ErrorCode::leased);
  queue.run();
  EXPECT_EQ(winch->limit, std::nullopt);
  ASSERT_TRUE(cell_stop.set_mode(number, Mode::programming));
  queue.run();
  EXPECT_EQ(winch->limit, kReducedSpeed);
  EXPECT_EQ(cell_stop.set_mode(number + 1, Mode::execution).error().code, ErrorCode::leased);
  queue.run();
  EXPECT_EQ(winch->limit, kReducedSpeed);
}

}  // namespace
}  // namespace race::server
