// People at the controls, as the audit log sees them.
#include "server/control/manual_control.h"

#include <gmock/gmock.h>

#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "core/rsm/document.h"
#include "tests/unit/server/hosted_cores.h"

namespace race::server {
namespace {

using testing::ElementsAre;
using namespace std::chrono_literals;

struct Person final : ControlClient {
  explicit Person(std::string account) : who{std::move(account), Role::cell_operator} {}
  void tell(Value message) override { heard.push_back(std::move(message)); }
  /// Of the messages that were heard.
  std::vector<std::string> kinds() const {
    std::vector<std::string> kinds;
    for (const Value& message : heard) kinds.push_back(message.find("kind")->as_string());
    return kinds;
  }
  /// Of the errors that were heard.
  std::vector<std::string> codes() const {
    std::vector<std::string> codes;
    for (const Value& message : heard)
      if (const Value* error = message.find("error")) codes.push_back(error->find("code")->as_string());
    return codes;
  }
  const Identity& identity() const override { return who; }
  const Identity who;
  std::vector<Value> heard;
};

// Its calls stay where they arrive: what is recorded, and who is answered, is decided before.
struct Arm final : services::Component {
  const rsm::Service& model() const override {
    static const rsm::Service arm =
        rsm::read_service_text(R"({"rsm": 1, "name": "robot", "states": [{"name": "Idle"}], "init": "Idle",
                                   "operations": [{"name": "move"}, {"name": "jog", "held": true},
                                                  {"name": "guide", "held": true}, {"name": "stop", "safe": true}]})",
                               "robot")
            .value();
    return arm;
  }
  void call(const services::Call&) override {}
};

struct ManualControlTest : HostedCores {
  void SetUp() override {
    host.declare("robot", "robot", queue);
    host.attach("robot", std::make_unique<Arm>());
    begin_server();
    cell_stop = std::make_unique<CellStop>(
        control, host, *cores, CellStop::Marks{StopMark(place.file("stopped")), ModeMark(place.file("mode"))},
        [](const std::string&) {});
    manual = std::make_unique<ManualControl>(
        control, host, *cell_stop, deadlines,
        [this](const Identity& who, const std::string& action, const std::string& outcome) {
          rows.push_back(who.account + ' ' + action + ' ' + outcome);
        });
  }
  void TearDown() override {
    cell_stop->end();
    HostedCores::TearDown();
  }
  static std::shared_ptr<Person> person(const char* account) { return std::make_shared<Person>(account); }
  void say(const std::shared_ptr<Person>& person, const char* text) { manual->request(person, text); }
  void take(const std::shared_ptr<Person>& person) { say(person, R"({"type": "take"})"); }
  void call(const std::shared_ptr<Person>& person, const std::string& service, const std::string& operation) {
    say(person, (R"({"type": "call", "number": 1, "service": ")" + service + R"(", "operation": ")" + operation + "\"}")
                    .c_str());
    ++calls;
    for (std::uint64_t made = 1; made <= calls; ++made) respond_to(made);
  }
  // So that few wait.
  void respond_to(std::uint64_t call) {
    services::Delivery delivery;
    delivery.kind = services::Delivery::Kind::response;
    delivery.caller = {Control::caller(control.holder()), call};
    manual->delivered(delivery);
  }
  // What was recorded since it was asked last.
  std::vector<std::string> recorded() { return std::exchange(rows, {}); }

  services::WorkQueue queue;
  Control control{[](const Value&) {}};
  std::unique_ptr<CellStop> cell_stop;
  std::unique_ptr<ManualControl> manual;
  std::vector<std::string> rows;
  std::uint64_t calls = 0;
  const std::shared_ptr<Person> ada = person("ada"), bob = person("bob");
};

TEST_F(ManualControlTest, WhoGetsThemIsARowAndWhoDoesNotIsNone) {
  take(ada);
  EXPECT_THAT(recorded(), ElementsAre("ada control take 200"));
  for (int i = 0; i < 100; ++i) take(bob);
  EXPECT_THAT(recorded(), ElementsAre());
  say(bob, R"({"type": "take", "force": true})");
  EXPECT_THAT(recorded(), ElementsAre("bob control ask 202"));
  for (int i = 0; i < 100; ++i) say(person("carol"), R"({"type": "take", "force": true})");
  EXPECT_THAT(recorded(), ElementsAre());
}

TEST_F(ManualControlTest, HowTheyEndIsARowOfWhoHadThem) {
  const auto end_row = [this](const std::function<void()>& end) {
    take(ada);
    recorded();
    end();
    EXPECT_EQ(control.holder(), 0U);
    return recorded();
  };
  EXPECT_THAT(end_row([&] { say(ada, R"({"type": "release"})"); }), ElementsAre("ada control end given_back"));
  EXPECT_THAT(end_row([&] { manual->disconnected(*ada); }), ElementsAre("ada control end closed"));
  EXPECT_THAT(end_row([&] { manual->check(std::chrono::steady_clock::now() + 1s); }),
              ElementsAre("ada control end silent"));
  manual->disconnected(*ada);
  say(ada, R"({"type": "release"})");
  EXPECT_THAT(recorded(), ElementsAre()) << "they have them no more";
}

TEST_F(ManualControlTest, WhoHadThemIsToldTheEndOnce) {
  const auto told = [this](const std::function<void()>& end) {
    take(ada);
    ada->heard.clear();
    end();
    return ada->kinds();
  };
  EXPECT_THAT(told([&] { say(ada, R"({"type": "release"})"); }), ElementsAre("released"));
  EXPECT_THAT(told([&] { manual->check(std::chrono::steady_clock::now() + 1s); }), ElementsAre("lost"));
  EXPECT_THAT(told([&] {
                say(bob, R"({"type": "take", "force": true})");
                ASSERT_TRUE(manual->answer_request({}, 1, true));
              }),
              ElementsAre("lost"));
}

TEST_F(ManualControlTest, ATakeOverIsARowOfWhoLosesThemAndOneOfWhoGetsThem) {
  take(ada);
  say(bob, R"({"type": "take", "force": true})");
  recorded();
  ASSERT_TRUE(manual->answer_request({}, 1, true));
  EXPECT_THAT(recorded(), ElementsAre("ada control end taken_over", "bob control take 200"));
}

TEST_F(ManualControlTest, TheEndIsARowThoughTheConnectionIsGone) {
  take(person("carol"));
  recorded();
  manual->check(std::chrono::steady_clock::now() + 1s);
  EXPECT_THAT(recorded(), ElementsAre("carol control end silent"));
}

TEST_F(ManualControlTest, ACallByHandIsARow) {
  call(ada, "robot", "move");
  EXPECT_THAT(recorded(), ElementsAre()) << "without the controls it moves nothing";
  take(ada);
  recorded();
  call(ada, "robot", "move");
  call(ada, "robot", "move");
  call(ada, "robot", "stop");
  call(bob, "robot", "move");
  EXPECT_THAT(recorded(), ElementsAre("ada control call robot.move accepted", "ada control call robot.move accepted",
                                      "ada control call robot.stop accepted"));
}

TEST_F(ManualControlTest, AJogThatIsHeldIsOneRow) {
  take(ada);
  recorded();
  for (int i = 0; i < 20; ++i) call(ada, "robot", "jog");
  call(ada, "robot", "stop");
  EXPECT_THAT(recorded(), ElementsAre("ada control call robot.jog accepted"));
  call(ada, "gripper", "stop");
  EXPECT_THAT(recorded(), ElementsAre("ada control call gripper.stop accepted")) << "of another service";
  std::this_thread::sleep_for(HeldOperation::kOneMotion + 10ms);
  call(ada, "robot", "jog");
  std::this_thread::sleep_for(HeldOperation::kOneMotion + 10ms);
  call(ada, "robot", "stop");
  EXPECT_THAT(recorded(), ElementsAre("ada control call robot.jog accepted", "ada control call robot.stop accepted"));
}

TEST_F(ManualControlTest, GuidingThatIsHeldIsOneRowAndOneOfItsOwn) {
  take(ada);
  call(ada, "robot", "jog");
  recorded();
  for (int i = 0; i < 20; ++i) call(ada, "robot", "guide");
  call(ada, "robot", "stop");
  EXPECT_THAT(recorded(), ElementsAre("ada control call robot.guide accepted"));
  for (int i = 0; i < 2; ++i) call(ada, "db", "guide");
  EXPECT_THAT(recorded(), ElementsAre("ada control call db.guide accepted", "ada control call db.guide accepted"))
      << "a service that does not say so has no button that is held";
}

TEST_F(ManualControlTest, AButtonThatIsHeldOverAStopIsAnsweredStopped) {
  take(ada);
  for (const char* operation : {"jog", "guide"}) {
    call(ada, "robot", operation);
    ada->heard.clear();
    control.stop({"bob", 0});
    control.reset();
    for (int i = 0; i < 3; ++i) call(ada, "robot", operation);
    EXPECT_EQ(ada->codes(), (std::vector<std::string>{"stopped", "stopped", "stopped"})) << operation;
    std::this_thread::sleep_for(Control::kSilence + 10ms);
    ada->heard.clear();
    say(ada, R"({"type": "beat"})");
    call(ada, "robot", operation);
    EXPECT_EQ(ada->codes(), std::vector<std::string>()) << "pressed again";
    std::this_thread::sleep_for(Control::kSilence + 10ms);
  }
}

TEST_F(ManualControlTest, AStopByARequestEndsWhatIsHeldAndIsARow) {
  const Identity carol{"carol", Role::cell_operator};
  const auto stop = [&] {
    EXPECT_TRUE(manual->call_by_request({carol}, {"robot", "stop"}, [](const Expected<Dict>&) {}));
    ++calls;  // has a number, too
  };
  take(ada);
  call(ada, "robot", "jog");
  recorded();
  ada->heard.clear();
  stop();
  EXPECT_THAT(recorded(), ElementsAre("carol service call robot.stop accepted"));
  for (int i = 0; i < 3; ++i) call(ada, "robot", "jog");
  EXPECT_EQ(ada->codes(), (std::vector<std::string>{"stopped", "stopped", "stopped"}));
  std::this_thread::sleep_for(Control::kSilence + 10ms);
  ada->heard.clear();
  say(ada, R"({"type": "beat"})");
  call(ada, "robot", "jog");
  EXPECT_EQ(ada->codes(), std::vector<std::string>()) << "pressed again";
  EXPECT_THAT(recorded(), ElementsAre("ada control call robot.jog accepted")) << "another motion";
}

TEST_F(ManualControlTest, TheirOwnStopAtTheEndOfAJogLetsThemPressAgainAtOnce) {
  take(ada);
  call(ada, "robot", "jog");
  ada->heard.clear();
  call(ada, "robot", "stop");
  call(ada, "robot", "jog");
  EXPECT_EQ(ada->codes(), std::vector<std::string>());
}

// Keeps what arrives.
struct Crane final : services::Component {
  explicit Crane(std::vector<std::string>& its_calls) : calls(its_calls) {}
  const rsm::Service& model() const override {
    static const rsm::Service crane =
        rsm::read_service_text(R"({"rsm": 1, "name": "crane", "states": [{"name": "Idle"}], "init": "Idle",
                                   "operations": [{"name": "jog", "held": true, "moves": true},
                                                  {"name": "stop", "safe": true}]})",
                               "crane")
            .value();
    return crane;
  }
  void call(const services::Call& call) override { calls.push_back(call.operation); }
  std::vector<std::string>& calls;
};

TEST_F(ManualControlTest, AJogThatIsOnItsWayWhenARequestStopsMovesNothingAfterIt) {
  std::vector<std::string> arrived;
  services::Host gated(clock, observer, &control);
  gated.declare("crane", "crane", queue);
  gated.attach("crane", std::make_unique<Crane>(arrived));
  ManualControl people(control, gated, *cell_stop, deadlines,
                       [](const Identity&, const std::string&, const std::string&) {});
  people.request(ada, R"({"type": "take"})");
  ASSERT_TRUE(cell_stop->set_mode(control.holder(), Mode::programming));
  const auto jog = [&] {
    people.request(ada, R"({"type": "call", "number": 1, "service": "crane", "operation": "jog"})");
  };
  jog();
  queue.run();
  EXPECT_THAT(arrived, ElementsAre("jog"));
  jog();
  ASSERT_TRUE(people.call_by_request({bob->who}, {"crane", "stop"}, [](const Expected<Dict>&) {}));
  jog();
  queue.run();
  EXPECT_THAT(arrived, ElementsAre("jog", "stop")) << "the second was let through before, and has not arrived";
}

TEST_F(ManualControlTest, AnAccountHasItsShareOfTheCallsByRequestsThatWait) {
  int responses = 0;
  const auto request = [&](const char* account) {
    const Identity who{account, Role::cell_operator};
    const auto begun = manual->call_by_request({who}, {"robot", "stop"}, [&](const Expected<Dict>&) { ++responses; });
    return begun ? "" : std::string(name(begun.error().code));
  };
  const auto respond = [&](std::uint64_t call) {
    services::Delivery delivery;
    delivery.kind = services::Delivery::Kind::response;
    delivery.caller = {"request", call};
    manual->delivered(delivery);
  };
  ASSERT_EQ(deadlines.size(), 0U);
  for (int i = 0; i < 4; ++i) EXPECT_EQ(request("ada"), "");
  EXPECT_EQ(request("ada"), "too_large");
  EXPECT_EQ(request("bob"), "");
  EXPECT_EQ(deadlines.size(), 5U) << "none of what was refused";
  for (std::uint64_t call = 1; call <= 5; ++call) respond(call);
  EXPECT_EQ(responses, 5);
  EXPECT_EQ(deadlines.size(), 0U) << "what was answered has none any more";
  for (int i = 0; i < 20; ++i) {
    EXPECT_EQ(request(""), i < 16 ? "" : "unavailable") << i << ": without accounts, all are those of one person";
  }
}

TEST_F(ManualControlTest, AJogOfTheNextPersonIsARowOfTheirs) {
  take(ada);
  call(ada, "robot", "jog");
  say(ada, R"({"type": "release"})");
  take(bob);
  recorded();
  call(bob, "robot", "jog");
  EXPECT_THAT(recorded(), ElementsAre("bob control call robot.jog accepted"));
}

}  // namespace
}  // namespace race::server
