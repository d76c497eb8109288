// The server's end and a process' end, joined without sockets: what a core sees must be what it sees of a component in
// the server.
#include "services/remote/remotes.h"

#include <gmock/gmock.h>

#include <atomic>
#include <condition_variable>
#include <future>
#include <random>

#include "core/value/json.h"
#include "services/remote/process_host.h"
#include "services/remote/process_link.h"
#include "services/remote/remote_world.h"
#include "tests/unit/services/remote/lamp.h"

namespace race::remote {
namespace {

using namespace std::chrono_literals;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

// What reaches cores and the log. Threads: any.
class Seen final : public services::HostObserver {
 public:
  void delivered(const services::Delivery& delivery) override {
    const Value* code = delivery.data.find("code");
    const bool response = delivery.kind == services::Delivery::Kind::response;
    note(all_, (response ? std::to_string(delivery.caller.call) + " " : "") + delivery.name +
                   (delivery.is_error ? " !> " + code->as_string() : " -> " + to_json(delivery.data)));
  }
  void changed(const services::ServiceStatus&) override { changed_.notify_all(); }
  void logged(services::Time, const std::string&, const std::string& text) override { note(log_, text); }

  std::vector<std::string> all() const { return copy(all_); }
  std::vector<std::string> log() const { return copy(log_); }
  /// Wakes who waits.
  void stir() { changed_.notify_all(); }
  void wait() {
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, 5ms);
  }

 private:
  void note(std::vector<std::string>& list, std::string text) {
    {
      const std::lock_guard lock(mutex_);
      list.push_back(std::move(text));
    }
    changed_.notify_all();
  }
  std::vector<std::string> copy(const std::vector<std::string>& list) const {
    const std::lock_guard lock(mutex_);
    return list;
  }
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<std::string> all_, log_;
};

// A process with lamps: its host, and the server's end of its connection.
struct Process {
  explicit Process(Remotes& remotes, std::vector<std::string> keys = {"lamp"})
      : Process(remotes, std::move(keys), {"lamp", "torches", "lantern"}) {}
  Process(Remotes& remotes, const std::vector<std::string>& keys, std::vector<std::string> groups)
      : link(remotes, std::move(groups)) {
    for (const std::string& key : keys) {
      auto made = std::make_unique<Lamp>(host.declare(key, "lamp"));
      lamp = made.get();
      host.attach(key, std::move(made));
    }
  }
  void hello() {
    host.connect(to_server);
    link.received(encode(host.hello()).value());
  }
  // Carries what waits, both ways.
  void pump() {
    while (auto encoded = link.out().pop()) {
      Message message = decode(*encoded, Reader::process).value();
      welcome = welcome || message.kind == Kind::welcome;
      if (message.kind == Kind::refused) {
        refused = to_json(message.value);
      } else {
        EXPECT_TRUE(host.handle(std::move(message)));
      }
    }
    while (auto encoded = to_server.pop()) link.received(std::move(*encoded));
  }
  SendQueue to_server;
  ProcessHost host;
  Lamp* lamp = nullptr;  // the last
  bool welcome = false;
  std::string refused;
  ProcessLink link;
};

struct RemotesTest : testing::Test {
  RemotesTest() : remotes(host, clock, 1s) {
    remotes.add("lamp", {{"lamp", "lamp", &lamp_model()}}, &world);
    remotes.add("torches", {{"torch", "lamp", &lamp_model()}, {"candle", "lamp", &lamp_model()}});
    remotes.add("lantern", {{"lantern",
                             "lamp",
                             &lamp_model(),
                             {[this](const std::string& function, const Dict&) -> Expected<Value> {
                                if (function != "colour")
                                  return unexpected(ErrorCode::not_found, "no such function", function);
                                return Value(colour);
                              },
                              [this] { return repainted.load(); }, [this] { ++cleaned; }}}});
  }
  ~RemotesTest() override {
    remotes.stop();
    host.stop();
  }
  void call(const std::string& operation, const std::string& key = "lamp") {
    host.call({"1", ++calls}, key, operation, {}, {});
  }
  // Lets the processes talk until `what` holds.
  template <typename What>
  bool until(std::vector<Process*> processes, What what) {
    const auto deadline = std::chrono::steady_clock::now() + 20s;
    for (;;) {
      for (Process* process : processes) process->pump();
      if (what()) return true;
      host.advance(false);
      if (std::chrono::steady_clock::now() > deadline) return false;
      seen.wait();
    }
  }
  bool available(const std::string& key = "lamp") { return host.service(key)->available; }
  void greet(Process& process, const std::string& key = "lamp") {
    process.hello();
    ASSERT_TRUE(until({&process}, [&] { return process.welcome && available(key); })) << process.refused;
  }

  Expected<RemoteWorld::Rules> is_round(const Value& value) {
    ++repainted;
    std::async(std::launch::async, [this] { remotes.step(); }).get();  // who steps the cell does not wait for this
    if (value == Value("flat")) return unexpected(ErrorCode::type, "must be round", "world");
    return RemoteWorld::Rules{{}, [](const Value&) { return Expected<void>(); }};
  }

  Seen seen;
  services::WorldClock clock;
  RemoteWorld world{clock, [this](const Value& value) { return is_round(value); }, {}};  // of lamp
  services::Host host{clock, seen};
  std::uint64_t calls = 0;
  // What the host functions of the lantern answer with.
  const std::string colour = "red";
  std::atomic<std::uint64_t> repainted{0};
  std::atomic<int> cleaned{0};
  Remotes remotes;
};

TEST_F(RemotesTest, AServiceIsUnavailableUntilItsProcessComes) {
  EXPECT_FALSE(available());
  EXPECT_EQ(host.models().at("lamp").operations.size(), 3U) << "programs are checked against it all the same";
  call("on");
  EXPECT_TRUE(until({}, [&] { return !seen.all().empty(); }));
  EXPECT_THAT(seen.all(), ElementsAre("1 on !> unavailable"));
  Process process(remotes);
  greet(process);
  call("on");
  EXPECT_TRUE(until({&process}, [&] { return seen.all().size() == 3; }));
  EXPECT_THAT(seen.all(), ElementsAre("1 on !> unavailable", "2 on -> null", "lit -> 1"));
}

TEST_F(RemotesTest, ACoreCannotTellTheDifference) {
  Seen there;
  services::Host local(clock, there);
  services::WorkQueue queue;
  local.attach("lamp", std::make_unique<Lamp>(local.declare("lamp", "lamp", queue)));
  Process process(remotes);
  greet(process);
  std::uint64_t number = 0;
  for (const char* operation : {"blink", "on", "on", "blink", "explode", "blink"}) {
    call(operation);
    local.call({"1", ++number}, "lamp", operation, {}, {});
    queue.run();
    EXPECT_TRUE(until({&process}, [&] {
      return seen.all().size() == there.all().size() &&
             process.lamp->calls.size() == (number > 4 ? number - 1 : number);
    }));
  }
  EXPECT_EQ(seen.all(), there.all());
  EXPECT_TRUE(until({&process}, [&] { return host.service("lamp")->last == local.service("lamp")->last; }));
  EXPECT_EQ(host.service("lamp")->state, local.service("lamp")->state);
  EXPECT_EQ(host.service("lamp")->violations.size(), local.service("lamp")->violations.size());
  local.stop();
}

TEST_F(RemotesTest, PendingCallsOfALostProcessAreAnsweredInTheirOrder) {
  Process process(remotes);
  greet(process);
  for (const char* operation : {"burn", "burn", "burn"}) call(operation);
  process.link.disconnect("its connection has ended");
  EXPECT_TRUE(until({}, [&] { return !available(); }));
  EXPECT_THAT(seen.all(), ElementsAre("1 burn !> unavailable", "2 burn !> unavailable", "3 burn !> unavailable"));
  EXPECT_THAT(seen.log(), Contains("lost: its connection has ended"));
}

// Nothing that it was to answer is lost without a word.
TEST_F(RemotesTest, AProcessThatDoesNotReadWhatItIsToldIsLost) {
  Process process(remotes);
  greet(process);
  call("burn");
  const Value large = List(200'000, Value(0.12345678901234568));  // 4 MB of JSON
  for (int i = 0; i < 40; ++i) host.call({"1", ++calls}, "lamp", "burn", {large}, {});
  ASSERT_TRUE(until({}, [&] { return process.link.out().overflowed(); }));
  EXPECT_TRUE(process.link.out().drained()) << "the writer ends the connection";
  process.link.check_heartbeat();
  ASSERT_TRUE(until({}, [&] { return !available(); }));
  EXPECT_EQ(seen.all().size(), calls);
  EXPECT_THAT(seen.all(), testing::Each(HasSubstr(" burn !> unavailable")));
  EXPECT_THAT(seen.log(), Contains("lost: it does not read what it is told"));
}

TEST_F(RemotesTest, WhatAProcessSaidBeforeItDiedCounts) {
  Process process(remotes);
  greet(process);
  call("on");
  ASSERT_TRUE(until({}, [&] {
    auto encoded = process.link.out().pop();
    return encoded && process.host.handle(decode(*encoded, Reader::process).value()) && process.lamp->calls.size() == 1;
  }));
  process.pump();
  process.link.disconnect("killed");
  EXPECT_TRUE(until({}, [&] { return !available(); }));
  EXPECT_THAT(seen.all(), ElementsAre("1 on -> null", "lit -> 1"));
}

TEST_F(RemotesTest, WhatComesBackStartsInItsInitialState) {
  auto first = std::make_unique<Process>(remotes);
  greet(*first);
  call("on");
  ASSERT_TRUE(until({first.get()}, [&] { return host.service("lamp")->state == "Bright"; }));
  first.reset();
  ASSERT_TRUE(until({}, [&] { return !available(); }));
  Process second(remotes);
  greet(second);
  EXPECT_EQ(host.service("lamp")->state, "Dark");
  call("on");
  EXPECT_TRUE(until({&second}, [&] { return seen.all().size() == 4; }));
  EXPECT_THAT(host.service("lamp")->violations, IsEmpty());
}

TEST_F(RemotesTest, AProcessIsToldOfALimitOfTheSpeedInOrder) {
  Process process(remotes);
  greet(process);
  EXPECT_THAT(process.lamp->wishes, IsEmpty());
  call("burn");
  ASSERT_TRUE(until({&process}, [&] { return process.lamp->calls.size() == 1; }));
  host.limit_speed(0.25);
  call("burn");
  ASSERT_TRUE(until({&process}, [&] { return process.lamp->calls.size() == 2; }));
  host.limit_speed({});
  ASSERT_TRUE(until({&process}, [&] { return process.lamp->wishes.size() == 2; }));
  EXPECT_THAT(process.lamp->wishes, ElementsAre("at most 0.25 after 1 calls", "at most any after 2 calls"));
}

TEST_F(RemotesTest, AProcessThatConnectsIsToldOfTheLimitOfTheSpeedBeforeAnyCall) {
  host.limit_speed(0.25);
  for (int connection = 0; connection < 2; ++connection) {
    Process process(remotes);
    process.hello();
    ASSERT_TRUE(until({}, [&] { return available(); }));
    call("burn");
    ASSERT_TRUE(until({&process}, [&] { return process.lamp->calls.size() == 1; }));
    EXPECT_THAT(process.lamp->wishes, ElementsAre("at most 0.25 after 0 calls")) << "connection " << connection;
    process.link.disconnect("killed");
    ASSERT_TRUE(until({}, [&] { return !available(); }));
  }
}

TEST_F(RemotesTest, AnAnswerOfThoseBeforeIsNotHeard) {
  Process first(remotes);
  greet(first);
  call("burn");
  first.link.disconnect("it answers no more");
  Process second(remotes);
  greet(second);
  Message late;
  late.kind = Kind::event;
  late.key = "lamp";
  late.name = "lit";
  first.link.received(encode(late).value());
  call("on");
  EXPECT_TRUE(until({&first, &second}, [&] { return seen.all().size() == 3; }));
  EXPECT_THAT(seen.all(), ElementsAre("1 burn !> unavailable", "2 on -> null", "lit -> 1"));
}

TEST_F(RemotesTest, TellsWhenWhatAProcessSaidIsHandledOrDropped) {
  Process process(remotes);
  process.hello();
  ASSERT_TRUE(until({&process}, [&] { return process.welcome; }));
  std::atomic<int> handled{0};
  process.link.on_handled([&] { ++handled; });
  Message pong;
  pong.kind = Kind::pong;
  process.link.received(encode(pong).value());
  while (process.link.is_behind()) std::this_thread::yield();
  while (handled == 0) std::this_thread::yield();
  remotes.stop();
  process.link.received(encode(pong).value());
  EXPECT_FALSE(process.link.is_behind());
  EXPECT_EQ(handled, 2);
  process.link.on_handled({});
}

TEST_F(RemotesTest, WhoAnswersNoPingIsLost) {
  Process process(remotes);
  greet(process);
  call("burn");
  for (int check = 0; check <= ProcessLink::kPingsPerHeartbeat; ++check) {
    EXPECT_TRUE(available()) << check;
    process.link.check_heartbeat();
  }
  process.link.check_heartbeat();
  EXPECT_TRUE(until({}, [&] { return !available(); }));
  EXPECT_THAT(seen.all(), ElementsAre("1 burn !> unavailable"));
  EXPECT_THAT(seen.log(), Contains("lost: it answers no more"));
}

TEST_F(RemotesTest, WhoAnswersPingsStays) {
  Process process(remotes);
  greet(process);
  for (int check = 0; check < 20; ++check) {
    process.link.check_heartbeat();
    // Its answer comes after the pong: the next check knows it.
    call("on");
    const std::size_t answers = static_cast<std::size_t>(check) + 2;  // with the event of the first
    ASSERT_TRUE(until({&process}, [&] { return seen.all().size() == answers; }));
  }
  EXPECT_TRUE(available());
}

TEST_F(RemotesTest, AProcessThatFitsNowhereIsRefused) {
  const auto refusal = [&](const Value& components, std::int64_t protocol = kProtocol) {
    Process process(remotes);
    Message hello;
    hello.kind = Kind::hello;
    hello.number = protocol;
    hello.value = components;
    process.link.received(encode(hello).value());
    process.pump();
    EXPECT_TRUE(process.link.out().drained());
    return process.refused;
  };
  const auto component = [](const char* key, const char* type, const rsm::Service& model) {
    return Value(Dict{{"key", key}, {"type", type}, {"rsm", rsm::write_service(model)}});
  };
  const Value lamp = component("lamp", "lamp", lamp_model()), torch = component("torch", "lamp", lamp_model());
  EXPECT_THAT(refusal(List{lamp}, 2), HasSubstr("speaks protocol 1"));
  EXPECT_THAT(refusal(List{}), HasSubstr("there is no component"));
  EXPECT_THAT(refusal(List{1}), HasSubstr("type"));
  EXPECT_THAT(refusal(List{component("heater", "lamp", lamp_model())}), HasSubstr("no service of this key waits"));
  EXPECT_THAT(refusal(List{component("lamp", "torch", lamp_model())}), HasSubstr("is of type `lamp` here"));
  rsm::Service other = lamp_model();
  other.operations.pop_back();
  EXPECT_THAT(refusal(List{component("lamp", "lamp", other)}), HasSubstr("another RSM"));
  other.init = "Nowhere";
  EXPECT_THAT(refusal(List{component("lamp", "lamp", other)}), HasSubstr("reference"));
  EXPECT_THAT(refusal(List{lamp, lamp}), HasSubstr("has a process already"));
  EXPECT_THAT(refusal(List{lamp, torch}), HasSubstr("belongs into another process"));
  EXPECT_FALSE(available());
  Process process(remotes);
  greet(process);
  EXPECT_THAT(refusal(List{lamp}), HasSubstr("has a process already"));
  EXPECT_TRUE(available()) << "the one that is there stays";
}

TEST_F(RemotesTest, TwoServicesOfOneProcessComeAndGoTogether) {
  auto process = std::make_unique<Process>(remotes, std::vector<std::string>{"torch", "candle"});
  greet(*process, "candle");
  EXPECT_TRUE(available("torch"));
  call("burn", "candle");
  call("burn", "torch");
  process.reset();
  EXPECT_TRUE(until({}, [&] { return !available("torch") && !available("candle"); }));
  EXPECT_THAT(seen.all(), testing::UnorderedElementsAre("1 burn !> unavailable", "2 burn !> unavailable"));
}

TEST_F(RemotesTest, AWorldComesAndGoesWithItsProcess) {
  const auto refusal = [&](const char* key, const char* shape) {
    Process process(remotes, {key});
    process.host.set_world({shape, {}, {}});
    process.hello();
    process.pump();
    return process.refused;
  };
  EXPECT_THAT(refusal("lamp", "flat"), HasSubstr("must be round"));
  EXPECT_THAT(refusal("lantern", "round"), HasSubstr("have no world here"));
  EXPECT_FALSE(available());
  {
    Process process(remotes);
    process.host.set_world({"round", [](const Value& act) { return Expected<Value>(act); }, {}});
    greet(process);
    EXPECT_EQ(world.world(), Value("round"));
    std::atomic<int> answered = 0;
    const auto done = [&](const Expected<Value>& answer) {
      answered = answer ? 1 : 2;
      seen.stir();
    };
    world.execute(
        "push", [] { return true; }, done);
    EXPECT_TRUE(until({&process}, [&] { return answered == 1; }));
    world.execute(
        "push", [] { return true; }, done);
    process.link.disconnect("gone");
    EXPECT_TRUE(until({}, [&] { return answered == 2; }));
    EXPECT_TRUE(world.world().is_null());
  }
  Process next(remotes);
  next.host.set_world({"round again", {}, {}});
  greet(next);
  EXPECT_EQ(world.world(), Value("round again"));
}

TEST_F(RemotesTest, PacketsPassBothWays) {
  services::WorkQueue queue;
  struct Camera final : services::Component {
    const rsm::Service& model() const override { return lamp_model(); }
    void call(const services::Call&) override {}
    void demand_changed(std::string_view, bool on) override { listened = on; }
    bool listened = false;
  };
  services::ServiceHost& camera = host.declare("camera", "camera", queue);
  auto made = std::make_unique<Camera>();
  const Camera& component = *made;
  host.attach("camera", std::move(made));
  Process process(remotes);
  greet(process);

  process.lamp->host.subscribe("camera", "images", true);
  ASSERT_TRUE(until({&process}, [&] { return queue.run(), component.listened; }));
  auto image = std::make_shared<services::Packet>();
  image->time = 2.5;
  image->bytes.resize(7);
  camera.publish("images", image);
  ASSERT_TRUE(until({&process}, [&] { return !process.lamp->packets.empty(); }));
  EXPECT_THAT(process.lamp->packets, ElementsAre("camera.images at 2.5: 7 bytes"));

  std::atomic<std::size_t> bytes = 0;
  const auto watch = host.watch("lamp", "light", [&](const services::PacketPtr& packet) {
    bytes = packet->bytes.size();
    seen.stir();
  });
  ASSERT_TRUE(until({&process}, [&] { return !process.lamp->wishes.empty(); }));
  process.lamp->host.publish("light", image);
  EXPECT_TRUE(until({&process}, [&] { return bytes == 7; }));
  host.unwatch(watch);
  process.link.disconnect("gone");
  EXPECT_TRUE(until({&process}, [&] { return queue.run(), !component.listened; })) << "nobody listens any more";
}

// A process that calls host functions; what the server answers, as text.
struct Asking : Process {
  explicit Asking(Remotes& remotes) : Process(remotes, {"lantern"}) {}
  void ask(const std::string& key, const std::string& function) {
    Message request;
    request.kind = Kind::request;
    request.key = key;
    request.number = 5;
    request.name = function;
    link.received(encode(request).value());
  }
  std::string said() {
    const auto encoded = link.out().pop();
    return encoded ? encoded->bytes : "";
  }
};

TEST_F(RemotesTest, AProcessIsAnsweredAtItsDesk) {
  Asking process(remotes);
  greet(process, "lantern");
  process.ask("lantern", "colour");
  std::string said;
  ASSERT_TRUE(until({}, [&] { return !(said = process.said()).empty(); }));
  EXPECT_EQ(said, R"({"type":"reply","number":5,"value":"red"})");
}

TEST_F(RemotesTest, WhoAsksWhatNoComponentAsksIsLost) {
  {
    Asking process(remotes);
    greet(process, "lantern");
    process.ask("lantern", "weight");
    EXPECT_TRUE(until({&process}, [&] { return process.link.out().drained(); }));
    EXPECT_THAT(process.refused, HasSubstr("weight"));
  }
  Asking process(remotes);
  greet(process, "lantern");
  process.ask("lamp", "colour");
  EXPECT_TRUE(until({&process}, [&] { return process.link.out().drained(); }));
  EXPECT_THAT(process.refused, HasSubstr("did not bring it"));
  Process lamp(remotes);
  greet(lamp);
  Message request;
  request.kind = Kind::request;
  request.key = "lamp";
  request.name = "colour";
  lamp.link.received(encode(request).value());
  EXPECT_TRUE(until({&lamp}, [&] { return lamp.link.out().drained(); }));
  EXPECT_THAT(lamp.refused, HasSubstr("nothing here that it could ask"));
}

TEST_F(RemotesTest, NewsReachTheProcessOnceAndBeforeACall) {
  Asking process(remotes);
  greet(process, "lantern");
  const auto next = [&] {
    std::string said;
    EXPECT_TRUE(until({}, [&] { return !(said = process.said()).empty(); }));
    return said;
  };
  ++repainted;
  remotes.step();
  EXPECT_THAT(next(), HasSubstr(R"({"type":"news","key":"lantern")"));
  remotes.step();
  call("on", "lantern");
  EXPECT_THAT(next(), HasSubstr(R"("type":"call")"));
  ++repainted;
  call("on", "lantern");
  EXPECT_THAT(next(), HasSubstr(R"("type":"news")"));
  EXPECT_THAT(next(), HasSubstr(R"("type":"call")"));
}

// A process that has read nothing yet: later news do not take the place of those that a call came after.
TEST_F(RemotesTest, NewsStayBeforeTheCallThatFollowedThem) {
  Asking process(remotes);
  greet(process, "lantern");
  std::atomic<int> waiting = 0;
  process.link.out().on_change([&] { ++waiting; });
  ++repainted;
  call("on", "lantern");
  ASSERT_TRUE(until({}, [&] { return waiting == 2; }));
  ++repainted;
  remotes.step();
  ASSERT_TRUE(until({}, [&] { return waiting == 3; }));
  process.link.out().on_change({});
  EXPECT_THAT(process.said(), HasSubstr(R"("type":"news")"));
  EXPECT_THAT(process.said(), HasSubstr(R"("type":"call")"));
  EXPECT_THAT(process.said(), HasSubstr(R"("type":"news")"));
}

TEST_F(RemotesTest, TheDeskIsCleanedWhenAProcessComesAndWhenItIsLost) {
  {
    Asking process(remotes);
    greet(process, "lantern");
    EXPECT_EQ(cleaned, 1);
  }
  EXPECT_TRUE(until({}, [&] { return cleaned == 2; }));
  EXPECT_FALSE(available("lantern")) << "who waits has been answered before";
}

// Whatever a process says after its hello, the server goes on, and what does not fit loses that process alone.
TEST_F(RemotesTest, NothingThatAProcessSaysHurtsTheServer) {
  std::mt19937 random(30);
  const auto below = [&](std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random); };
  const std::vector<std::string> names = {"t1", "t2", "t3", "lit", "on", "blink", "images", "", "lamp", "torch"};
  for (int round = 0; round < 300; ++round) {
    Process process(remotes);
    greet(process);
    call("burn");
    for (std::size_t n = below(20); n > 0; --n) {
      Message message;
      message.kind = static_cast<Kind>(below(static_cast<std::size_t>(Kind::ping) + 1));
      message.key = below(20) == 0 ? names[below(names.size())] : "lamp";
      message.name = names[below(names.size())];
      message.service = names[below(names.size())];
      message.call = below(3) == 0 ? calls : below(1000);
      message.time = static_cast<double>(below(100)) - 50;
      message.on = below(2) == 0;
      message.value = Dict{{"code", names[below(names.size())]}};
      message.bytes.resize(below(50));
      EncodedMessage encoded = encode(message).value();
      if (below(20) == 0) {
        char& byte = encoded.bytes[below(encoded.bytes.size())];
        byte = static_cast<char>(static_cast<unsigned char>(byte) ^ (1U << below(8)));
      }
      process.link.received(std::move(encoded));
    }
    process.link.disconnect("enough");
    ASSERT_TRUE(until({}, [&] { return !available(); }));
  }
  Process process(remotes);
  greet(process);
  const std::size_t before = seen.all().size();
  call("on");
  EXPECT_TRUE(until({&process}, [&] { return seen.all().size() == before + 2; }));
}

}  // namespace
}  // namespace race::remote
