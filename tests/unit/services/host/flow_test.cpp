// Data flows between services: packets pass from one to the other, past the cores, while somebody listens.
#include <gmock/gmock.h>

#include <utility>

#include "core/rsm/document.h"
#include "tests/unit/services/host/bench.h"

namespace race::services {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

const rsm::Service& basin_model() {
  static const rsm::Service model =
      rsm::read_service_text(R"({"rsm": 1, "name": "basin", "subscribes": [{"service": "tap", "event": "water"}],
                                 "states": [{"name": "Open"}], "init": "Open"})",
                             "basin")
          .value();
  return model;
}

// Publishes and takes what a test tells it.
class Vessel final : public Component {
 public:
  Vessel(const rsm::Service& its_model, ServiceHost& its_host) : host(its_host), model_(its_model) {}
  const rsm::Service& model() const override { return model_; }
  void call(const Call&) override {}
  void packet(std::string_view key, std::string_view flow, const PacketPtr& packet) override {
    if (broken) throw std::runtime_error("overflow");
    got.push_back(std::string(key) + "." + std::string(flow) + "@" + std::to_string(static_cast<int>(packet->time)));
  }
  void demand_changed(std::string_view flow, bool on) override {
    wishes.push_back((on ? "+" : "-") + std::string(flow));
  }
  void pour(Time time) { host.publish("water", std::make_shared<Packet>(Packet{time, {}, {}})); }

  ServiceHost& host;
  std::vector<std::string> got, wishes;
  bool broken = false;

 private:
  const rsm::Service& model_;
};

struct FlowTest : testing::Test {
  FlowTest() : tap(bench.add<Vessel>("tap", tap_model())), basin(bench.add<Vessel>("basin", basin_model())) {}
  void listen(bool on) {
    basin.host.subscribe("tap", "water", on);
    bench.queue.run();
  }
  // The tap pours now and then every 100 ms, `times` in all.
  void pour_evenly(int times) {
    for (int i = 0; i < times; ++i) {
      if (i > 0) bench.pass(0.1);
      tap.pour(i);
    }
    bench.queue.run();
  }
  // How often observers were told of a service since this was asked last.
  std::size_t told() {
    bench.pass(Host::kStatusPeriod);
    return std::exchange(bench.changes, {}).size();
  }
  Published water() const { return bench.host.service("tap")->publishes.at(0); }
  bool basin_listens() const { return bench.host.service("basin")->subscribes.at(0).listening; }
  Bench bench;
  Vessel& tap;
  Vessel& basin;
};

TEST_F(FlowTest, APacketReachesWhoListensOnItsOwnUnitAndNoCore) {
  listen(true);
  tap.pour(1);
  EXPECT_THAT(basin.got, IsEmpty());
  bench.queue.run();
  EXPECT_THAT(basin.got, ElementsAre("tap.water@1"));
  EXPECT_THAT(bench.deliveries, IsEmpty());
}

TEST_F(FlowTest, NothingComesBeforeAndAfterListening) {
  tap.pour(1);
  listen(true);
  listen(false);
  tap.pour(2);
  bench.queue.run();
  EXPECT_THAT(basin.got, IsEmpty());
}

TEST_F(FlowTest, ANewerPacketReplacesOneThatStillWaits) {
  listen(true);
  tap.pour(1);
  tap.pour(2);
  bench.queue.run();
  EXPECT_THAT(basin.got, ElementsAre("tap.water@2"));
}

TEST_F(FlowTest, APacketOnItsWayIsNotHandedToWhoStoppedListening) {
  listen(true);
  tap.pour(1);
  basin.host.subscribe("tap", "water", false);
  bench.queue.run();
  EXPECT_THAT(basin.got, IsEmpty());
}

TEST_F(FlowTest, ThePublisherIsToldOnceWhenSomebodyListensAndWhenNobodyDoes) {
  listen(true);
  listen(true);
  const auto watch = bench.host.watch("tap", "water", [](const PacketPtr&) {});
  listen(false);
  bench.queue.run();
  EXPECT_THAT(tap.wishes, ElementsAre("+water"));
  bench.host.unwatch(watch);
  bench.queue.run();
  EXPECT_THAT(tap.wishes, ElementsAre("+water", "-water"));
}

TEST_F(FlowTest, APublisherThatComesLaterIsToldToo) {
  std::vector<Time> seen;
  bench.host.watch("spring", "water", [&](const PacketPtr& packet) { seen.push_back(packet->time); });
  auto& spring = bench.add<Vessel>("spring", tap_model());
  bench.queue.run();
  EXPECT_THAT(spring.wishes, ElementsAre("+water"));
  spring.pour(3);
  EXPECT_THAT(seen, ElementsAre(3.0));
}

TEST_F(FlowTest, AWatcherOutsideSeesEveryPacketUntilItLeaves) {
  std::vector<Time> seen;
  const auto watch = bench.host.watch("tap", "water", [&](const PacketPtr& packet) { seen.push_back(packet->time); });
  tap.pour(1);
  tap.pour(2);
  bench.host.unwatch(watch);
  bench.host.unwatch(watch);
  tap.pour(3);
  EXPECT_THAT(seen, ElementsAre(1.0, 2.0));
}

TEST_F(FlowTest, AFlowThatTheRsmDoesNotListIsAViolationAndNotHeard) {
  basin.host.subscribe("tap", "steam", true);
  ASSERT_EQ(bench.violations("basin").size(), 1U);
  EXPECT_EQ(bench.violations("basin")[0].rule, "subscribes");
  bench.queue.run();
  EXPECT_THAT(tap.wishes, IsEmpty());
}

TEST_F(FlowTest, ASubscriberThatIsLostIsSubscribedNoLonger) {
  listen(true);
  basin.broken = true;
  tap.pour(1);
  bench.queue.run();
  EXPECT_FALSE(bench.host.service("basin")->available);
  bench.queue.run();
  EXPECT_THAT(tap.wishes, ElementsAre("+water", "-water"));
}

TEST_F(FlowTest, AServiceTellsWhatItOffersWhatItReadsAndWhetherItListens) {
  EXPECT_EQ(water().flow, "water");
  EXPECT_EQ(bench.host.service("basin")->subscribes.at(0).service, "tap");
  EXPECT_FALSE(basin_listens());
  listen(true);
  EXPECT_TRUE(basin_listens());
  listen(false);
  EXPECT_FALSE(basin_listens());
}

TEST_F(FlowTest, WatchersAreCountedAndListeningServicesAreNone) {
  listen(true);
  const auto first = bench.host.watch("tap", "water", [](const PacketPtr&) {});
  const auto second = bench.host.watch("tap", "water", [](const PacketPtr&) {});
  EXPECT_EQ(water().watchers, 2U);
  bench.host.unwatch(first);
  EXPECT_EQ(water().watchers, 1U);
  bench.host.unwatch(second);
  EXPECT_EQ(water().watchers, 0U);
}

TEST_F(FlowTest, TheRateIsThatOfTheHostsClock) {
  listen(true);
  pour_evenly(1);
  EXPECT_EQ(water().rate_hz, 0);
  pour_evenly(25);
  bench.pass(0.1);
  EXPECT_NEAR(water().rate_hz, 10, 1e-6);
  EXPECT_EQ(water().last->time, 24);
}

TEST_F(FlowTest, APublisherThatFallsSilentHasNoRate) {
  listen(true);
  pour_evenly(5);
  bench.pass(2);
  EXPECT_EQ(water().rate_hz, 0);
  EXPECT_TRUE(water().last.has_value());
}

TEST_F(FlowTest, ASlowFlowHasARateToo) {
  listen(true);
  tap.pour(0);
  bench.pass(5);
  tap.pour(1);
  EXPECT_NEAR(water().rate_hz, 0.2, 1e-6);
}

TEST_F(FlowTest, NothingPassesOnceNobodyListensOrThePublisherIsGone) {
  for (const bool lost : {false, true}) {
    listen(true);
    pour_evenly(5);
    EXPECT_GT(water().rate_hz, 0);
    lost ? bench.host.disconnect("tap") : listen(false);
    EXPECT_EQ(water().rate_hz, 0);
    EXPECT_FALSE(water().last.has_value());
  }
}

TEST_F(FlowTest, APacketThatNobodyWantsIsNotCounted) {
  pour_evenly(5);
  EXPECT_FALSE(water().last.has_value());
}

TEST_F(FlowTest, ObserversAreToldAtFirstAndThenOnceASecond) {
  told();
  listen(true);
  EXPECT_EQ(told(), 2U) << "publisher and listener";
  pour_evenly(2);
  EXPECT_EQ(told(), 2U);
  pour_evenly(25);
  EXPECT_EQ(told(), 2U);
}

TEST_F(FlowTest, ObserversAreToldOnceWhenNothingPassesAnyMore) {
  listen(true);
  pour_evenly(5);
  told();
  bench.pass(1.2);
  EXPECT_EQ(told(), 0U) << "three periods and a second have not passed";
  EXPECT_NEAR(water().rate_hz, 10, 1e-6);
  bench.pass(5);
  EXPECT_EQ(told(), 1U);
  EXPECT_EQ(water().rate_hz, 0);
  pour_evenly(2);
  EXPECT_EQ(told(), 2U);
  EXPECT_NEAR(water().rate_hz, 10, 1e-6) << "the pause does not count";
}

TEST_F(FlowTest, ObserversAreToldWhoListensAndWhoWatches) {
  told();
  const auto watch = bench.host.watch("tap", "water", [](const PacketPtr&) {});
  EXPECT_EQ(told(), 1U);
  bench.host.unwatch(watch);
  EXPECT_EQ(told(), 1U);
  listen(true);  // publisher and subscriber
  EXPECT_EQ(told(), 2U);
}

TEST_F(FlowTest, WhoOverhearsGetsWhatPassesBecauseOfOthersAndAsksForNothing) {
  std::vector<Time> heard;
  const auto id = bench.host.overhear("tap", "water", [&](const PacketPtr& packet) { heard.push_back(packet->time); });
  bench.queue.run();
  EXPECT_THAT(tap.wishes, IsEmpty());
  EXPECT_EQ(water().watchers, 0u);
  listen(true);
  EXPECT_THAT(tap.wishes, ElementsAre("+water"));
  tap.pour(1);
  bench.queue.run();
  EXPECT_THAT(heard, ElementsAre(1));
  listen(false);
  EXPECT_THAT(tap.wishes, ElementsAre("+water", "-water"));
  bench.host.unwatch(id);
  listen(true);
  tap.pour(2);
  bench.queue.run();
  EXPECT_THAT(heard, ElementsAre(1));
  EXPECT_THAT(tap.wishes, ElementsAre("+water", "-water", "+water"));
}

}  // namespace
}  // namespace race::services
