// Services that processes bring of themselves: who may, what becomes of them, and what a process that lies does.
#include "services/remote/own_services.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <atomic>
#include <mutex>
#include <thread>

#include "core/rsm/document.h"
#include "core/value/json.h"
#include "services/remote/process_link.h"
#include "services/remote/protocol.h"
#include "tests/unit/services/remote/lamp.h"

namespace race::remote {
namespace {

using namespace std::chrono_literals;
using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

rsm::Service toggle_model() {
  return rsm::read_service_text(R"json({"rsm": 1, "name": "toggle", "operations": [{"name": "flip"}],
    "states": [{"name": "Off"}, {"name": "Lit"}], "init": "Off",
    "transitions": [{"id": "up", "src": "Off", "dst": "Lit", "operation": "flip"},
                    {"id": "down", "src": "Lit", "dst": "Off", "operation": "flip"}]})json",
                                "toggle")
      .value();
}

Value offered(const std::string& key, const std::string& type, const rsm::Service& model) {
  return Dict{{"key", key}, {"type", type}, {"rsm", rsm::write_service(model)}};
}

// Threads: any.
class Witness final : public services::HostObserver {
 public:
  void delivered(const services::Delivery& delivery) override {
    const std::lock_guard lock(mutex_);
    const Value* code = delivery.data.find("code");
    answers_.push_back(std::to_string(delivery.caller.call) + " " + delivery.name +
                       (delivery.is_error ? " !> " + code->as_string() : " -> " + to_json(delivery.data)));
  }
  void changed(const services::ServiceStatus&) override {}
  void redescribed() override { ++described; }
  void logged(services::Time, const std::string&, const std::string& text) override {
    const std::lock_guard lock(mutex_);
    log_.push_back(text);
  }
  std::vector<std::string> answers() const {
    const std::lock_guard lock(mutex_);
    return answers_;
  }
  std::vector<std::string> log() const {
    const std::lock_guard lock(mutex_);
    return log_;
  }
  std::atomic<int> described{0};

 private:
  mutable std::mutex mutex_;
  std::vector<std::string> answers_, log_;
};

// A process, as the server hears it: what it is told is kept.
struct Peer {
  explicit Peer(Remotes& remotes, std::vector<std::string> groups = {"own"}, std::string account = {})
      : link(remotes, std::move(groups), std::move(account)) {}
  Peer& hello(List components, bool hears_violations = false) {
    Message message;
    message.kind = Kind::hello;
    message.number = kProtocol;
    message.value = std::move(components);
    message.on = hears_violations;
    link.received(encode(message).value());
    return *this;
  }
  void say(Kind kind, const std::string& name, services::CallId call = 0, Value value = {}) {
    Message message;
    message.kind = kind;
    message.key = "toggle";
    message.name = name;
    message.call = call;
    message.value = std::move(value);
    link.received(encode(message).value());
  }
  // Reads what it was told.
  void read() {
    while (auto encoded = link.out().pop()) told.push_back(decode(*encoded, Reader::process).value());
  }
  std::vector<Message> of(Kind kind) {
    read();
    std::vector<Message> found;
    std::ranges::copy_if(told, std::back_inserter(found), [&](const Message& each) { return each.kind == kind; });
    return found;
  }
  std::string refusal() {
    const auto refused = of(Kind::refused);
    return refused.empty() ? "none" : to_json(refused.front().value);
  }
  std::vector<Message> told;
  ProcessLink link;
};

struct OwnServicesTest : testing::Test {
  OwnServicesTest() : remotes(host, clock, 1s) {
    host.attach("lamp", std::make_unique<Lamp>(host.declare("lamp", "lamp", queue)));
  }
  ~OwnServicesTest() override {
    remotes.stop();
    host.stop();
  }
  void open(std::optional<std::set<std::string>> accounts = {}) { remotes.add_own({}, std::move(accounts)); }
  template <typename What>
  static bool until(What what) {
    for (const auto end = std::chrono::steady_clock::now() + 20s; std::chrono::steady_clock::now() < end;) {
      if (what()) return true;
      std::this_thread::sleep_for(1ms);
    }
    return false;
  }
  bool available(const std::string& key = "toggle") {
    const auto status = host.service(key);
    return status && status->available;
  }
  void call(const std::string& operation, const std::string& key = "toggle") {
    host.call({"1", ++calls}, key, operation, {}, {});
  }
  std::string refusal(List components, std::vector<std::string> groups = {"own"}, std::string account = {}) {
    return Peer(remotes, std::move(groups), std::move(account)).hello(std::move(components)).refusal();
  }

  Witness seen;
  services::WorldClock clock;
  services::WorkQueue queue;
  services::Host host{clock, seen};
  std::uint64_t calls = 0;
  Remotes remotes;
};

TEST_F(OwnServicesTest, IsThereWithItsRsmWhenItsProcessComes) {
  open();
  EXPECT_FALSE(host.service("toggle"));
  call("flip");
  ASSERT_TRUE(until([&] { return !seen.answers().empty(); }));
  Peer peer(remotes);
  peer.hello({offered("toggle", "switch", toggle_model())});
  ASSERT_TRUE(until([&] { return available(); })) << peer.refusal();
  const auto status = *host.service("toggle");
  EXPECT_EQ(status.type, "switch");
  EXPECT_EQ(status.state, "Off");
  EXPECT_EQ(*status.model, toggle_model());
  EXPECT_EQ(host.models().at("toggle"), toggle_model());
  EXPECT_EQ(seen.described, 1);
  EXPECT_EQ(peer.of(Kind::welcome).size(), 1U);
  call("flip");
  ASSERT_TRUE(until([&] { return peer.of(Kind::call).size() == 1; }));
  const services::CallId id = peer.of(Kind::call)[0].call;
  peer.say(Kind::transition, "up", id);
  peer.say(Kind::result, "", id, 5);
  ASSERT_TRUE(until([&] { return seen.answers().size() == 2; }));
  EXPECT_THAT(seen.answers(), ElementsAre("1 flip !> unavailable", "2 flip -> 5"));
  EXPECT_EQ(host.service("toggle")->state, "Lit");
  EXPECT_THAT(host.service("toggle")->violations, IsEmpty());
}

TEST_F(OwnServicesTest, StaysKnownWhenItsProcessIsGoneAndBeginsAnewWhenItComesBack) {
  open();
  auto peer = std::make_unique<Peer>(remotes);
  peer->hello({offered("toggle", "switch", toggle_model())});
  ASSERT_TRUE(until([&] { return available(); }));
  call("flip");
  ASSERT_TRUE(until([&] { return peer->of(Kind::call).size() == 1; }));
  peer->say(Kind::transition, "up", peer->of(Kind::call)[0].call);
  ASSERT_TRUE(until([&] { return host.service("toggle")->state == "Lit"; }));
  peer.reset();
  ASSERT_TRUE(until([&] { return !available(); }));
  EXPECT_THAT(seen.answers(), ElementsAre("1 flip !> unavailable"));
  EXPECT_EQ(*host.service("toggle")->model, toggle_model());
  Peer again(remotes);
  again.hello({offered("toggle", "switch", toggle_model())});
  ASSERT_TRUE(until([&] { return available(); }));
  EXPECT_EQ(host.service("toggle")->state, "Off");
  EXPECT_EQ(seen.described, 1) << "its RSM is the one that is known";
}

TEST_F(OwnServicesTest, ComesBackWithAnotherRsm) {
  open();
  auto peer = std::make_unique<Peer>(remotes);
  peer->hello({offered("toggle", "switch", toggle_model())});
  ASSERT_TRUE(until([&] { return available(); }));
  peer->say(Kind::transition, "down");
  ASSERT_TRUE(until([&] { return !host.service("toggle")->violations.empty(); }));
  const auto before = *host.service("toggle");
  peer.reset();
  ASSERT_TRUE(until([&] { return !available(); }));
  Peer again(remotes);
  again.hello({offered("toggle", "dimmer", lamp_model())});
  ASSERT_TRUE(until([&] { return available(); }));
  const auto now = *host.service("toggle");
  EXPECT_EQ(now.type, "dimmer");
  EXPECT_EQ(now.state, "Dark");
  EXPECT_EQ(*now.model, lamp_model());
  EXPECT_THAT(now.violations, IsEmpty()) << "those of before were against another RSM";
  EXPECT_EQ(*before.model, toggle_model()) << "who has looked still sees what was";
  EXPECT_EQ(seen.described, 2);
  call("flip");
  ASSERT_TRUE(until([&] { return !seen.answers().empty(); }));
  EXPECT_THAT(seen.answers(), ElementsAre("1 flip !> unavailable")) << "an operation that it has no more";
  call("on");
  EXPECT_TRUE(until([&] { return again.of(Kind::call).size() == 1; }));
}

TEST_F(OwnServicesTest, WhatIsNoServiceIsRefusedWithTheReason) {
  open();
  rsm::Service wrong = toggle_model(), empty;
  wrong.init = "Nowhere";
  const std::string longest(OwnServices::kKeyBytes, 'k');
  for (const char* key : {"", "7up", "a b", "a/b", "ü"})
    EXPECT_THAT(refusal({offered(key, "switch", toggle_model())}), HasSubstr("\"name\"")) << key;
  EXPECT_THAT(refusal({offered("toggle", "a type", toggle_model())}), HasSubstr("\"name\""));
  EXPECT_THAT(refusal({offered(longest + "k", "switch", toggle_model())}), HasSubstr("\"name\""));
  EXPECT_EQ(refusal({offered(longest, "switch", toggle_model())}), "none");
  EXPECT_THAT(refusal({offered("toggle", "switch", wrong)}), HasSubstr("\"reference\""));
  EXPECT_THAT(refusal({offered("toggle", "switch", empty)}), HasSubstr("\"missing\""));
  EXPECT_THAT(refusal({offered("lamp", "lamp", lamp_model())}), HasSubstr("no service of this key waits"))
      << "the server has one";
  EXPECT_THAT(refusal({offered("a", "t", toggle_model()), offered("a", "t", toggle_model())}),
              HasSubstr("has a process already"));
  EXPECT_TRUE(available("lamp"));
  EXPECT_FALSE(host.service("toggle")) << "nothing is left of what was refused";
  EXPECT_FALSE(host.service("a"));
}

TEST_F(OwnServicesTest, AnRsmHasABoundedSize) {
  open();
  rsm::Service large = toggle_model();
  const auto grow = [&](std::size_t bytes) {
    large.meta = Value();
    const std::size_t rest = to_json(rsm::write_service(large)).size() + std::string(R"(,"meta":"")").size();
    large.meta = std::string(bytes - rest, 'x');
    EXPECT_EQ(to_json(rsm::write_service(large)).size(), bytes);
  };
  grow(OwnServices::kRsmBytes + 1);
  EXPECT_THAT(refusal({offered("toggle", "switch", large)}), HasSubstr("\"too_large\""));
  grow(OwnServices::kRsmBytes);
  EXPECT_EQ(refusal({offered("toggle", "switch", large)}), "none");
}

TEST_F(OwnServicesTest, NoMoreThanSoManyAreKnown) {
  open();
  std::vector<std::unique_ptr<Peer>> peers;
  for (std::size_t i = 0; i < OwnServices::kMost; ++i) {
    peers.push_back(std::make_unique<Peer>(remotes));
    peers.back()->hello({offered("s" + std::to_string(i), "switch", toggle_model())});
    ASSERT_EQ(peers.back()->refusal(), "none") << i;
  }
  EXPECT_THAT(refusal({offered("more", "switch", toggle_model())}),
              AllOf(HasSubstr("\"too_large\""), HasSubstr("more")));
  peers.clear();
  EXPECT_THAT(refusal({offered("more", "switch", toggle_model())}), HasSubstr("\"too_large\""))
      << "those that are gone stay known";
  EXPECT_EQ(refusal({offered("s7", "switch", toggle_model())}), "none") << "and may come back";
}

TEST_F(OwnServicesTest, OnlyWhoMayBringsThem) {
  open(std::set<std::string>{"workshop", "office"});
  const List toggle = {offered("toggle", "switch", toggle_model())};
  EXPECT_THAT(refusal(toggle, {"cell", "audio"}), HasSubstr("\"rights\""));
  EXPECT_THAT(refusal(toggle, {"own"}, "kitchen"), HasSubstr("\"rights\""));
  EXPECT_EQ(refusal(toggle, {"own"}, "workshop"), "none");
  ASSERT_TRUE(until([&] { return !available(); }));
  EXPECT_THAT(refusal(toggle, {"own"}, "office"), HasSubstr("\"rights\"")) << "nobody takes the key of another account";
  EXPECT_EQ(refusal(toggle, {"own"}), "none") << "a process of the server's own user";
}

TEST_F(OwnServicesTest, NobodyBringsAnyWhereTheServerExpectsNone) {
  EXPECT_THAT(refusal({offered("toggle", "switch", toggle_model())}), HasSubstr("no service of this key waits"));
}

TEST_F(OwnServicesTest, OneThatTheCellExpectsHasTheRsmOfTheCell) {
  static const rsm::Service model = toggle_model();
  remotes.add_own({{"toggle", "switch", &model}}, {});
  EXPECT_EQ(host.models().at("toggle"), model) << "tasks are checked against it before it comes";
  EXPECT_THAT(refusal({offered("toggle", "switch", lamp_model())}), HasSubstr("another RSM"));
  EXPECT_THAT(refusal({offered("toggle", "lamp", model)}), HasSubstr("is of type `switch` here"));
  Peer peer(remotes);
  peer.hello({offered("toggle", "switch", model), offered("other", "lamp", lamp_model())});
  EXPECT_TRUE(until([&] { return available() && available("other"); })) << peer.refusal();
  EXPECT_EQ(seen.described, 1) << "the other one alone";
}

TEST_F(OwnServicesTest, MayComeTogetherOrByThemselves) {
  open();
  const Value a = offered("a", "switch", toggle_model()), b = offered("b", "switch", toggle_model());
  auto both = std::make_unique<Peer>(remotes);
  both->hello({a, b});
  ASSERT_TRUE(until([&] { return available("a") && available("b"); }));
  EXPECT_THAT(refusal({b}), HasSubstr("has a process already"));
  both.reset();
  Peer one(remotes), other(remotes);
  one.hello({b});
  other.hello({a});
  ASSERT_TRUE(until([&] { return available("a") && available("b"); }));
  one.link.disconnect("gone");
  ASSERT_TRUE(until([&] { return !available("b"); }));
  EXPECT_TRUE(available("a"));
}

// 10 000 messages: wrong, doubled, late, unknown.
TEST_F(OwnServicesTest, EachLieOfAProcessIsReportedWithRuleAndCallAndOthersAreServed) {
  open();
  Peer peer(remotes);
  peer.hello({offered("toggle", "switch", toggle_model())}, true);
  ASSERT_TRUE(until([&] { return available(); }));
  constexpr std::size_t kLies = 10'000;
  for (std::size_t lie = 0; lie < kLies; ++lie) {
    switch (lie % 5) {
      case 0:
        peer.say(Kind::transition, "down");  // leaves `Lit`, and waits for a call
        peer.say(Kind::transition, "nowhere");
        break;
      case 1:
        peer.say(Kind::result, "", 900'000 + lie, 1);  // of a call that nobody has made
        break;
      case 2:
        peer.say(Kind::reject, "", 900'000 + lie);
        break;
      case 3:
        peer.say(Kind::event, "boom");
        break;
      default:
        peer.say(Kind::error, "", 900'000 + lie, Dict{{"code", "late"}});
    }
    peer.read();
    host.advance(false);
  }
  const auto count = [](const std::vector<std::string>& lines, const std::string& begin, const std::string& end) {
    const auto is_one = [&](const std::string& line) { return line.starts_with(begin) && line.ends_with(end); };
    return static_cast<std::size_t>(std::ranges::count_if(lines, is_one));
  };
  ASSERT_TRUE(until([&] { return count(seen.log(), "respond: ", "(call 909999)") == 1; }));
  const auto log = seen.log();
  EXPECT_EQ(count(log, "declared: there is no transition `nowhere`", ""), kLies / 5);
  EXPECT_EQ(count(log, "R7: ", ")"), kLies / 5);
  EXPECT_EQ(count(log, "respond: ", ")"), 2 * kLies / 5) << "each with its call";
  EXPECT_EQ(count(log, "declared: there is no event `boom`", ""), kLies / 5);
  const auto has_last = [&] {
    const auto told = peer.of(Kind::violation);
    return !told.empty() && told.back().name == "respond" && told.back().call == 909'999U;
  };
  ASSERT_TRUE(until(has_last)) << "its author is told, too";
  EXPECT_EQ(host.service("toggle")->violations.size(), services::CallLedger::kViolationsKept);
  call("on", "lamp");
  queue.run();
  EXPECT_THAT(seen.answers(), Contains("1 on -> null"));
  EXPECT_TRUE(available()) << "and it is not lost";
}

TEST_F(OwnServicesTest, WhoDoesNotAskIsToldOfNoViolation) {
  open();
  Peer peer(remotes);
  peer.hello({offered("toggle", "switch", toggle_model())});
  ASSERT_TRUE(until([&] { return available(); }));
  peer.say(Kind::event, "boom");
  call("flip");
  ASSERT_TRUE(until([&] { return peer.of(Kind::call).size() == 1; }));
  EXPECT_THAT(peer.of(Kind::violation), IsEmpty());
  EXPECT_EQ(host.service("toggle")->violations.size(), 1U);
}

}  // namespace
}  // namespace race::remote
