#include "server/stream/flow_channels.h"

#include <gmock/gmock.h>

#include "core/value/json.h"
#include "server/wire/channel_names.h"
#include "server/wire/path_pattern.h"
#include "services/host/work_queue.h"
#include "tests/unit/server/bench.h"
#include "tests/unit/server/boxed_subscriber.h"
#include "tests/unit/services/host/bench.h"

namespace race::server {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// Publishes what a test tells it, and notes who wants it.
class Tap final : public services::Component {
 public:
  explicit Tap(services::ServiceHost& its_host) : host(its_host) {}
  const rsm::Service& model() const override { return services::tap_model(); }
  void call(const services::Call&) override {}
  void demand_changed(std::string_view, bool on) override { is_wanted = on; }
  void pour(services::Time time) {
    host.publish("water", std::make_shared<services::Packet>(services::Packet{time, {}, {}}));
  }

  services::ServiceHost& host;
  bool is_wanted = false;
};

struct PacketClient final : BoxedSubscriber {
  /// The times of the packets that came since.
  std::vector<double> times() {
    std::vector<double> times;
    for (const Value& message : messages()) {
      if (const Value* time = message.find("data")->find("time")) times.push_back(time->to_double());
    }
    return times;
  }
};

struct FlowChannelsTest : testing::Test {
  FlowChannelsTest() {
    services::ServiceHost& service = host.declare("tap", "tap", queue);
    auto made = std::make_unique<Tap>(service);
    tap = made.get();
    host.attach("tap", std::move(made));
  }
  // Until the stream has done what it was asked for: its strands take turns on the one thread.
  void settle() {
    for (int i = 0; i < 20; ++i) Strand(pool).ask([] { return 0; });
    queue.run();
  }
  void watch(bool on) {
    on ? hub.subscribe(client, "flow/tap/water", {}) : hub.unsubscribe(client, "flow/tap/water");
    settle();
  }
  // What the client gets of packets at these times, each taken before the next comes.
  std::vector<double> pour(std::vector<double> poured) {
    std::vector<double> got;
    for (const double time : poured) {
      tap->pour(time);
      settle();
      for (const double each : client->times()) got.push_back(each);
    }
    return got;
  }

  std::optional<Source> find(const std::string& name) {
    const auto parameters = match(kFlowChannel, name);
    return parameters ? channels->source(parameters->at("service"), parameters->at("flow")) : std::nullopt;
  }

  NoObserver observer;
  services::WorldClock clock;
  services::WorkQueue queue;
  services::Host host{clock, observer};
  Pool pool{1};
  Hub hub{pool, 1, [this](const std::string& name) { return find(name); }};
  std::unique_ptr<FlowChannels> channels = std::make_unique<FlowChannels>(host, hub, pool);
  std::shared_ptr<PacketClient> client = std::make_shared<PacketClient>();
  Tap* tap = nullptr;
};

TEST_F(FlowChannelsTest, AreThoseOfTheFlowsThatServicesOffer) {
  EXPECT_TRUE(find("flow/tap/water"));
  for (const char* name :
       {"flow/tap/steam", "flow/spring/water", "flow/tap", "flow//water", "flow/tap/", "flow/", "tap/water"})
    EXPECT_FALSE(find(name)) << name;
}

TEST_F(FlowChannelsTest, AServiceWorksOnlyWhileItsChannelHasSubscribers) {
  EXPECT_FALSE(tap->is_wanted);
  watch(true);
  EXPECT_TRUE(tap->is_wanted);
  watch(false);
  EXPECT_FALSE(tap->is_wanted);
}

TEST_F(FlowChannelsTest, ADisconnectedSubscriberNoLongerWatches) {
  watch(true);
  hub.disconnect(client);
  settle();
  EXPECT_FALSE(tap->is_wanted);
}

TEST_F(FlowChannelsTest, ATakerOfEachMessageGetsFivePacketsInASecond) {
  watch(true);
  EXPECT_THAT(pour({1.0, 1.1, 1.2, 1.3, 1.399}), ElementsAre(1.0, 1.2, 1.399));
}

TEST_F(FlowChannelsTest, APublisherWhoseTimeBeginsAnewIsNotSilent) {
  watch(true);
  EXPECT_THAT(pour({100, 0.0, 0.1}), ElementsAre(100, 0.0));
}

TEST_F(FlowChannelsTest, ASlowTakerGetsTheNewestAlone) {
  watch(true);
  for (int i = 0; i < 5; ++i) {
    tap->pour(i);
    settle();
  }
  EXPECT_THAT(client->times(), ElementsAre(4));
}

TEST_F(FlowChannelsTest, WhoComesAgainIsNotShownThePast) {
  watch(true);
  pour({1});
  watch(false);
  watch(true);
  EXPECT_THAT(client->times(), IsEmpty());
  EXPECT_THAT(pour({1.01}), ElementsAre(1.01));
}

}  // namespace
}  // namespace race::server
