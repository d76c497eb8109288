// Which calls of a core its services learn that nobody waits for any more.
#include <gmock/gmock.h>

#include "core/rsm/document.h"
#include "server/execution/live_edits.h"
#include "tests/unit/server/hosted_cores.h"

namespace race::server {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

const rsm::Service& clock_model() {
  static const rsm::Service model =
      rsm::read_service_text(
          R"({"operations": [{"name": "wait"}, {"name": "stop", "safe": true}], "events": [{"name": "tick"}]})",
          "clock")
          .value();
  return model;
}

// Answers nothing.
class Clock final : public services::Component {
 public:
  const rsm::Service& model() const override { return clock_model(); }
  void call(const services::Call& call) override { happened.push_back(call.operation + std::to_string(call.id)); }
  void abandoned(services::CallId call) override { happened.push_back("abandoned" + std::to_string(call)); }
  std::vector<std::string> happened;
};

// A waits, and again at each tick, or nobody does.
constexpr const char* kDocument = R"json({"rcm": 1, "name": "waiting", "root": {"state": "Root", "children": [
  {"state": "A", "entry": "svc.t.wait(1)", "actions": [{"when": "svc.t.tick == 'break'", "do": "var.x = 1 / 0"}], "ports": [
    {"name": "again", "when": "svc.t.tick == 'again'", "to": "A"},
    {"name": "gone", "when": "svc.t.tick == 'gone'", "to": "B"}]},
  {"state": "B"}], "first": "A", "ports": [{"name": "over", "when": "svc.t.tick == 'over'"}]}})json";

struct AbandonedCalls : HostedCores {
  void SetUp() override {
    host.declare("t", "clock", queue);
    auto component = std::make_unique<Clock>();
    clock = component.get();
    host.attach("t", std::move(component));
    begin_server();
    core = cores->create({"waiting", 1, rcm::read_document_text(kDocument).value()}, {}).value();
    ASSERT_TRUE(core->start());
  }
  void TearDown() override {
    core.reset();
    HostedCores::TearDown();
  }
  void deliver_tick(const std::string& data) {
    services::Delivery delivery;
    delivery.key = "t";
    delivery.name = "tick";
    delivery.data = Value(data);
    delivery.data.freeze();
    delivery.units = delivery.data.size_units();
    core->deliver(delivery);
  }
  // What the service has been told since the last time, once the core has taken a tick with `data`.
  std::vector<std::string> tick(const std::string& data) {
    const std::int64_t next = core->info().find("step")->as_integer() + 1;
    deliver_tick(data);
    wait(*core, [next](const Value& info) { return info.find("step")->as_integer() == next; });
    return happened();
  }
  std::vector<std::string> happened() {
    queue.run();
    return std::exchange(clock->happened, {});
  }

  services::WorkQueue queue;
  Clock* clock = nullptr;
  std::shared_ptr<Core> core;
};

TEST_F(AbandonedCalls, AreThoseThatALaterOneSupersedes) {
  EXPECT_THAT(happened(), ElementsAre("wait1"));
  EXPECT_THAT(tick("again"), ElementsAre("abandoned1", "wait2")) << "its place is free before the next call";
  EXPECT_THAT(tick("gone"), IsEmpty()) << "the response to who was left can be received";
}

TEST_F(AbandonedCalls, AreAllOfARunThatEnds) {
  EXPECT_THAT(tick("over"), ElementsAre("wait1", "abandoned1"));
  EXPECT_EQ(status(core->info()), "ended");
}

TEST_F(AbandonedCalls, AreAllOfARunThatFaults) {
  EXPECT_THAT(tick("break"), ElementsAre("wait1", "stop2", "abandoned1", "abandoned2"));
  EXPECT_EQ(status(core->info()), "faulted");
}

TEST_F(AbandonedCalls, AreAllOfACoreThatIsDeleted) {
  ASSERT_TRUE(cores->remove(core->id()));
  EXPECT_THAT(happened(), ElementsAre("wait1", "stop2", "abandoned1", "abandoned2"));
}

// Section 9 of core/SEMANTICS.md: the calls of removed callers are dropped.
TEST_F(AbandonedCalls, AreThoseOfAStateThatAnEditRemoves) {
  const auto documents = Documents::open(folder.store()).value();
  LiveEdits edits(*documents, *cores);
  ASSERT_TRUE(documents->put("waiting", kDocument));
  core = cores->create(documents->get("waiting").value(), {}).value();
  ASSERT_TRUE(core->start());
  ASSERT_TRUE(core->set_live(true));
  EXPECT_THAT(tick("gone"), ElementsAre("wait1", "wait2"));
  const auto revision = documents->put("waiting", R"({"rcm": 1, "name": "waiting", "root": {"state": "Root",
    "children": [{"state": "B"}], "first": "B", "ports": [{"name": "over", "when": "svc.t.tick == 'over'"}]}})");
  edits.changed("waiting");
  wait(*core, [&](const Value& info) { return *info.find("revision") == Value(revision->revision.number); });
  EXPECT_THAT(happened(), ElementsAre("abandoned2"));
  edits.close();
}

// Its open calls are answered `unavailable` when it goes on.
TEST_F(AbandonedCalls, AreAllOfARunThatTheDiskInterrupts) {
  disk.fail_at(1, sqlite::FaultyVfs::Fault::full, true);
  deliver_tick("gone");
  wait(*core, [](const Value& now) { return now.find("status")->as_string() == "interrupted"; });
  disk.repair();
  EXPECT_THAT(happened(), ElementsAre("wait1", "stop2", "abandoned1"));
}

}  // namespace
}  // namespace race::server
