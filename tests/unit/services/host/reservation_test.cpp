// Answers that another thread prepares: world time waits for them where it can, and gives them in one order.
#include <gmock/gmock.h>

#include <future>

#include "core/rsm/document.h"
#include "services/host/worker.h"
#include "tests/unit/services/host/bench.h"

namespace race::services {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

const rsm::Service& idle_model() {
  static const rsm::Service model =
      rsm::read_service_text(R"({"rsm": 1, "name": "slow", "states": [{"name": "On"}], "init": "On"})", "slow").value();
  return model;
}

class SlowComponent final : public Component {
 public:
  explicit SlowComponent(ServiceHost& its_host) : host(its_host), worker(its_host) {}
  const rsm::Service& model() const override { return idle_model(); }
  void call(const Call&) override {}
  ServiceHost& host;
  Worker worker;
};

struct ReservationTest : testing::Test {
  ReservationTest() : first(bench.add<SlowComponent>("first")), second(bench.add<SlowComponent>("second")) {}
  /// An answer that notes its name and the world time at which it runs.
  std::function<void()> note(std::string name) {
    return [this, name] { notes.push_back(name + "@" + std::to_string(bench.milliseconds)); };
  }
  Bench bench;
  std::vector<std::string> notes;
  SlowComponent& first;
  SlowComponent& second;
};

TEST_F(ReservationTest, AnAnswerRunsAtItsTimeHoweverEarlyItIsThere) {
  first.host.fulfil(first.host.reserve(0.005), note("a"));
  bench.pass(0.010);
  EXPECT_THAT(notes, ElementsAre("a@5"));
}

TEST_F(ReservationTest, TimeWaitsForAnAnswerThatIsDue) {
  std::promise<void> may_go_on;
  first.worker.submit(0.003, [&, go_on = may_go_on.get_future().share()] {
    go_on.wait();
    return note("slow");
  });
  bench.pass(0.002);
  EXPECT_THAT(notes, IsEmpty());
  std::thread later([&] { may_go_on.set_value(); });
  bench.pass(0.010);
  later.join();
  EXPECT_THAT(notes, ElementsAre("slow@3"));
}

TEST_F(ReservationTest, InRealTimeNobodyWaitsAndALateAnswerRunsAtOnce) {
  const ReservationId reservation = first.host.reserve(0.003);
  const auto real_time = [&](int ms) {
    bench.clock.set(static_cast<double>(bench.milliseconds = ms) / 1000);
    bench.host.advance(false);
    bench.queue.run();
  };
  real_time(7);
  EXPECT_THAT(notes, IsEmpty());
  first.host.fulfil(reservation, note("late"));
  real_time(8);
  EXPECT_THAT(notes, ElementsAre("late@8"));
}

TEST_F(ReservationTest, AnswersComeByTimeThenServiceThenReservation) {
  const ReservationId d = second.host.reserve(0.002), c = first.host.reserve(0.002), e = second.host.reserve(0.002),
                      a = second.host.reserve(0.001);
  second.host.fulfil(e, note("e"));
  second.host.fulfil(d, note("d"));
  first.host.fulfil(c, note("c"));
  second.host.fulfil(a, note("a"));
  bench.pass(0.002);
  EXPECT_THAT(notes, ElementsAre("a@1", "c@2", "d@2", "e@2"));
}

TEST_F(ReservationTest, AnEmptyAnswerGivesTheTimeBack) {
  first.host.fulfil(first.host.reserve(0.001), {});
  bench.pass(0.002);
  EXPECT_THAT(notes, IsEmpty());
}

TEST_F(ReservationTest, NobodyWaitsForALostService) {
  first.host.reserve(0.001);
  bench.host.disconnect("first");
  bench.pass(0.002);
  EXPECT_EQ(bench.milliseconds, 2);
}

TEST_F(ReservationTest, AComponentWhoseWorkThrowsIsLost) {
  first.worker.submit(0.001, []() -> Worker::Answer { throw std::runtime_error("no idea"); });
  bench.pass(0.002);
  EXPECT_FALSE(bench.host.service("first")->available);
  EXPECT_THAT(bench.log, ElementsAre("lost: no idea"));
}

}  // namespace
}  // namespace race::services
