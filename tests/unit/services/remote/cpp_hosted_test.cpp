// Services of one's own in C++ (api/cpp) at a host that holds them against their RSM, without sockets.
#include <gmock/gmock.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <limits>
#include <memory>
#include <stdexcept>
#include <thread>

#include "api/cpp/race_client/hosted.h"
#include "core/value/json.h"
#include "tests/unit/services/host/bench.h"

namespace race::client {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

// A service with the operations that a test adds.
struct CppHosted : testing::Test {
  CppHosted() { declaration.key = declaration.type = "grip"; }
  DeclaredOperation& add(std::string name, Operation::Handler handler) {
    DeclaredOperation& made = declaration.operations.emplace_back();
    made.model.name = std::move(name);
    made.model.error = "any";
    made.handler = std::move(handler);
    return made;
  }
  // `move` pauses until it is stopped, `stop` stops it, `state` tells in which state the service is.
  void add_gripper() {
    DeclaredOperation& move = add("move", [this](Call& call) {
      const int at_work = ++moving;
      most_moving = std::max(most_moving.load(), at_work);
      try {
        call.pause(call.number("seconds"));
      } catch (const Stopped&) {
        ++stopped;
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        --moving;
        throw;
      }
      --moving;
      return Value(call.number("seconds"));
    });
    move.busy = "Moving";
    move.model.parameters.push_back({"seconds", "number", "s", "", 0, 60, std::nullopt});
    DeclaredOperation& stop = add("stop", [this](Call&) { return Value(++stops); });
    stop.model.safe = true;
    stop.stops = "Moving";
    add("state", [this](Call&) { return Value(hosted.state()); });
  }
  void begin() {
    auto model = model_of(declaration);
    ASSERT_TRUE(model) << model.error();
    if (!bench) hosted.set_model(std::move(*model));
    bench = std::make_unique<services::Bench>();
    auto made = hosted.component(bench->host.declare("grip", "grip", bench->queue));
    component = made.get();
    bench->host.attach("grip", std::move(made));
    hosted.connected();
  }
  void call(const std::string& operation, List args = {}, Dict kwargs = {}) {
    bench->host.call({std::to_string(++cores), 1}, "grip", operation, std::move(args), std::move(kwargs));
    bench->queue.run();
  }
  // All so far, once there are so many.
  std::vector<std::string> responses(std::size_t count) {
    for (int tries = 0; tries < 5000 && bench->responses().size() < count; ++tries) {
      bench->pass(0.001);
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return bench->responses();
  }
  std::vector<std::string> violations() const {
    std::vector<std::string> all;
    for (const services::Violation& each : bench->violations("grip")) all.push_back(each.rule + ": " + each.message);
    return all;
  }
  void wait_until(const std::function<bool()>& holds) {
    for (int tries = 0; tries < 5000 && !holds(); ++tries) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    ASSERT_TRUE(holds());
  }

  std::atomic<int> moving = 0, most_moving = 0, stopped = 0, stops = 0;
  int cores = 0;
  Declaration declaration;
  Hosted hosted{declaration};
  std::unique_ptr<services::Bench> bench;  // its component uses the others
  services::Component* component = nullptr;
};

TEST_F(CppHosted, AnswersWhatIsNotBusyInOrder) {
  add_gripper();
  begin();
  call("state");
  call("stop");
  EXPECT_THAT(responses(2), ElementsAre(R"(grip.state -> "Ready")", "grip.stop -> 1"));
  EXPECT_THAT(violations(), IsEmpty());
}

TEST_F(CppHosted, ChecksArgumentsBeforeTheHandler) {
  add_gripper();
  begin();
  call("move");
  call("move", {61});
  call("move", {"long"});
  call("move", {1}, {{"seconds", 1}});
  call("move", {}, {{"hours", 1}});
  EXPECT_THAT(responses(5), ElementsAre("grip.move !> invalid", "grip.move !> out_of_range", "grip.move !> invalid",
                                        "grip.move !> invalid", "grip.move !> invalid"));
  EXPECT_EQ(bench->deliveries.at(1).data.find("argument")->as_string(), "seconds");
  EXPECT_EQ(most_moving, 0);
  EXPECT_EQ(hosted.state(), "Ready");
  call("move", {0});
  EXPECT_EQ(responses(6).back(), "grip.move -> 0.0");
}

TEST_F(CppHosted, IsBusyUntilItsHandlerReturns) {
  add_gripper();
  begin();
  call("move", {0.05});
  call("state");
  call("move", {0.05});
  EXPECT_THAT(responses(3), ElementsAre(R"(grip.state -> "Moving")", "grip.move !> not_accepted", "grip.move -> 0.05"));
  EXPECT_EQ(hosted.state(), "Ready");
  EXPECT_THAT(violations(), IsEmpty());
}

TEST_F(CppHosted, IsStoppedAndBeginsAnewWhenTheHandlerHasEnded) {
  add_gripper();
  begin();
  call("move", {60});
  wait_until([&] { return moving == 1; });
  call("stop");
  call("move", {0.01});
  EXPECT_THAT(responses(3), UnorderedElementsAre("grip.move !> stopped", "grip.stop -> 1", "grip.move -> 0.01"));
  EXPECT_EQ(stopped, 1);
  EXPECT_EQ(most_moving, 1) << "the second waited for the first";
  EXPECT_THAT(violations(), IsEmpty());
}

TEST_F(CppHosted, EndsAndHaltsWhenTheServerIsLost) {
  add_gripper();
  begin();
  call("move", {60});
  wait_until([&] { return moving == 1; });
  hosted.lost();
  EXPECT_EQ(stops, 1);
  EXPECT_EQ(hosted.state(), "");
  EXPECT_TRUE(hosted.wait_for_handlers(5));
  EXPECT_EQ(stopped, 1);
  hosted.lost();
  EXPECT_EQ(stops, 1) << "it is lost already";
  begin();
  call("state");
  EXPECT_THAT(responses(1), ElementsAre(R"(grip.state -> "Ready")")) << "nothing of the call before";
}

TEST_F(CppHosted, AnswersWhatIsBusyWhenTheServerIsSilent) {
  add_gripper();
  bool has_halted = false;
  declaration.on_halt = [&] { has_halted = true; };
  begin();
  call("move", {60});
  wait_until([&] { return moving == 1; });
  component->halt();
  EXPECT_THAT(responses(1), ElementsAre("grip.move !> stopped"));
  EXPECT_TRUE(has_halted);
  EXPECT_EQ(stops, 0) << "on_halt says what is done";
  EXPECT_EQ(hosted.state(), "Ready");
  EXPECT_THAT(violations(), IsEmpty());
}

TEST_F(CppHosted, AnswersWhatAHandlerThrows) {
  add("jam", [](Call&) -> Value { throw Failure("jammed", "the fingers are jammed", {{"force", 5.0}, {"code", 1}}); });
  add("fail", [](Call&) -> Value { throw std::runtime_error("no device"); });
  add("garble", [](Call&) { return Value("\xFF"); });
  add("ask", [](Call& call) { return Value(call.number("width")); });
  begin();
  for (const char* operation : {"jam", "fail", "garble", "ask"}) call(operation);
  responses(4);
  std::vector<std::string> errors;
  for (const auto& delivery : bench->deliveries) errors.push_back(to_json(delivery.data));
  EXPECT_THAT(errors, ElementsAre(R"({"code":"jammed","message":"the fingers are jammed","force":5.0})",
                                  R"({"code":"failed","message":"no device"})",
                                  R"({"code":"failed","message":"the result has a text that is not UTF-8"})",
                                  R"({"code":"failed","message":"there is no argument `width`"})"));
}

TEST_F(CppHosted, AnnouncesFromAnyThreadInOrderAndBounded) {
  declaration.events.push_back({{"counted", "int", false, std::nullopt, ""}, {}});
  add("go", [](Call&) { return Value(); });
  begin();
  constexpr int kMany = 3 * Inbox::kMost;
  std::atomic<bool> done = false;
  std::thread counter([&] {
    for (int number = 0; number < kMany; ++number) hosted.emit("counted", number);
    done = true;
  });
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  EXPECT_FALSE(done) << "more than may wait";
  while (!done) bench->pass(0.001);
  counter.join();
  bench->pass(0.001);
  ASSERT_EQ(bench->deliveries.size(), std::size_t{kMany});
  EXPECT_EQ(bench->deliveries.back().data, Value(kMany - 1));
  EXPECT_THROW(hosted.emit("counted", std::numeric_limits<double>::quiet_NaN()), std::invalid_argument);
  EXPECT_THROW(hosted.emit("a b", 1), std::invalid_argument);
  EXPECT_THROW(hosted.take("nowhere"), std::invalid_argument);
}

TEST_F(CppHosted, KnowsTheLimitOfItsSpeedWhileItIsConnected) {
  add_gripper();
  begin();
  EXPECT_EQ(hosted.speed_limit(), std::nullopt);
  bench->host.limit_speed(0.25);
  bench->queue.run();
  EXPECT_EQ(hosted.speed_limit(), 0.25);
  hosted.log(std::string(301, 'x'));
  EXPECT_EQ(bench->log.back(), std::string(300, 'x'));
  hosted.lost();
  begin();
  EXPECT_EQ(hosted.speed_limit(), std::nullopt);
}

TEST_F(CppHosted, EndsTheHandlerWhosePlaceALaterCallTakes) {
  add("go", [this](Call& call) {
    ++moving;
    try {
      call.pause(call.number("seconds"));
    } catch (const Stopped&) {
      ++stopped;
      throw;
    }
    return Value(call.number("seconds"));
  });
  declaration.rsm_text = R"json({
      "rsm": 1, "name": "grip", "operations": [{"name": "go", "parameters": [{"name": "seconds"}], "error": "any"}],
      "events": [], "states": [{"name": "A"}], "init": "A",
      "transitions": [{"id": "go", "src": "A", "dst": "A", "operation": "go", "defer": ["done"]},
                      {"id": "done", "src": "A", "dst": "A"}]})json";
  begin();
  call("go", {60});
  wait_until([&] { return moving == 1; });
  call("go", {0.01});
  EXPECT_THAT(responses(1), ElementsAre("grip.go -> 0.01"));
  EXPECT_EQ(stopped, 1);
  EXPECT_THAT(violations(), IsEmpty());
}

// An RSM of one's own: calls that may be concurrent.
struct CppConcurrent : CppHosted {
  CppConcurrent() {
    add("wait", [this](Call& call) {
      ++moving;
      call.pause(call.number("seconds"));
      return Value(call.number("seconds"));
    });
    declaration.rsm_text = R"json({
      "rsm": 1, "name": "grip", "operations": [{"name": "wait", "parameters": [{"name": "seconds"}], "error": "any"}],
      "events": [], "states": [{"name": "A"}], "init": "A",
      "transitions": [{"id": "wait", "src": "A", "dst": "A", "operation": "wait", "defer": ["over", "end"], "concurrent": true},
                      {"id": "over", "src": "A", "dst": "A"}, {"id": "end", "dst": "A", "error": "ended"}]})json";
    begin();
  }
};

TEST_F(CppConcurrent, AnswersEachWhenItIsDone) {
  call("wait", {0.3});
  call("wait", {0.01});
  EXPECT_THAT(responses(2), ElementsAre("grip.wait -> 0.01", "grip.wait -> 0.3"));
  EXPECT_THAT(violations(), IsEmpty());
}

TEST_F(CppConcurrent, TakesATransitionThatAnswersAll) {
  call("wait", {60});
  call("wait", {60});
  wait_until([&] { return moving == 2; });
  hosted.take("end");
  EXPECT_THAT(responses(2), ElementsAre("grip.wait !> ended", "grip.wait !> ended"));
  EXPECT_TRUE(hosted.wait_for_handlers(5));
  EXPECT_THAT(violations(), IsEmpty());
}

TEST_F(CppConcurrent, HasAHundredHandlersAtWork) {
  for (std::size_t number = 0; number < Workers::kMost; ++number) call("wait", {60});
  call("wait", {60});
  EXPECT_THAT(responses(1), ElementsAre("grip.wait !> too_many"));
  hosted.take("end");
  EXPECT_EQ(responses(Workers::kMost + 1).size(), Workers::kMost + 1);
  EXPECT_TRUE(hosted.wait_for_handlers(5));
  call("wait", {0.01});
  EXPECT_EQ(responses(Workers::kMost + 2).back(), "grip.wait -> 0.01");
  EXPECT_THAT(violations(), IsEmpty());
}

}  // namespace
}  // namespace race::client
