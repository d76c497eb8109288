// The service: started and stopped by calls, fed by the camera alone, and heard as events.
#include <gmock/gmock.h>

#include <limits>

#include "core/value/json.h"
#include "services/camera/camera.h"
#include "services/recognition/object_recognition.h"
#include "tests/unit/services/host/bench.h"
#include "tests/unit/services/recognition/cell.h"

namespace race::recognition {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// Camera and recognition of the demonstrator, with time that passes and a world that stands still.
struct Fixture {
  explicit Fixture(std::uint64_t seed = 1) : world(build(demo_scene())) {
    auto& eye = bench.host.declare("camera", "KinectDriver", bench.queue);
    bench.host.attach("camera", std::make_unique<camera::Camera>(eye, *world, seed));
    auto& mind = bench.host.declare("obj_rec", "ObjectRecognition", bench.queue);
    bench.host.attach("obj_rec", std::make_unique<ObjectRecognition>(mind, demo_parts()));
  }
  ~Fixture() { bench.host.stop(); }
  /// The labels of each event so far.
  std::vector<std::vector<std::string>> labels() const {
    std::vector<std::vector<std::string>> all;
    for (const auto& delivery : bench.deliveries) {
      if (delivery.kind != services::Delivery::Kind::event) continue;
      auto& one = all.emplace_back();
      for (const Value& object : delivery.data.find("objects")->as_list())
        one.push_back(object.find("label")->as_string());
    }
    return all;
  }
  services::Bench bench;
  std::unique_ptr<world::World> world;
};

TEST(ObjectRecognition, IsIdleAndSilentUntilItIsStarted) {
  Fixture fixture;
  fixture.bench.pass(0.5);
  EXPECT_EQ(fixture.bench.host.service("obj_rec")->state, "Idle");
  EXPECT_THAT(fixture.labels(), IsEmpty());
}

TEST(ObjectRecognition, TellsOfThePartsThatWereAskedForAndStopsWhenTold) {
  Fixture fixture;
  fixture.bench.call("obj_rec", "start", {List{Value("Tape")}});
  EXPECT_EQ(fixture.bench.host.service("obj_rec")->state, "Recognizing");
  fixture.bench.pass(0.45);
  EXPECT_THAT(fixture.labels(), ElementsAre(ElementsAre("Tape"), ElementsAre("Tape")));
  fixture.bench.call("obj_rec", "stop");
  const auto before = fixture.labels().size();
  fixture.bench.pass(0.5);
  EXPECT_EQ(fixture.labels().size(), before);
  EXPECT_THAT(fixture.bench.responses(), ElementsAre("obj_rec.start -> null", "obj_rec.stop -> null"));
  EXPECT_THAT(fixture.bench.violations("obj_rec"), IsEmpty());
}

TEST(ObjectRecognition, NeedsNoPicturesWhileItIsStopped) {
  Fixture fixture;
  fixture.bench.call("obj_rec", "start");
  fixture.bench.call("obj_rec", "stop");
  int pictures = 0;
  fixture.bench.pass(0.3);
  const auto watch = fixture.bench.host.watch("camera", "frame", [&](const auto&) { ++pictures; });
  fixture.bench.queue.run();
  fixture.bench.host.unwatch(watch);
  fixture.bench.pass(0.3);
  EXPECT_EQ(pictures, 0);
}

TEST(ObjectRecognition, RefusesWrongArgumentsAndIsIdleThen) {
  const std::vector<std::pair<Value, std::string>> cases = {{List{Value("Spoon")}, "not_found"},
                                                            {List{Value("Tape"), Value("Spoon")}, "not_found"},
                                                            {List{}, "out_of_range"},
                                                            {Value("Tape"), "type"},
                                                            {List{Value(3)}, "type"},
                                                            {Value(std::numeric_limits<double>::quiet_NaN()), "type"}};
  for (const auto& [labels, code] : cases) {
    Fixture fixture;
    fixture.bench.call("obj_rec", "start", {labels});
    ASSERT_THAT(fixture.bench.responses(), ElementsAre("obj_rec.start !> " + code));
    EXPECT_EQ(fixture.bench.deliveries[0].data.find("argument")->as_string(), "labels");
    EXPECT_EQ(fixture.bench.host.service("obj_rec")->state, "Idle");
    fixture.bench.pass(0.3);
    EXPECT_THAT(fixture.labels(), IsEmpty());
  }
}

TEST(ObjectRecognition, GivesTheSameEventsForTheSameSeedOnly) {
  const auto events = [](std::uint64_t seed) {
    Fixture fixture(seed);
    fixture.bench.call("obj_rec", "start");
    fixture.bench.pass(0.6);
    std::string all;
    for (const auto& delivery : fixture.bench.deliveries)
      all += std::to_string(delivery.time) + to_json(delivery.data) + "\n";
    return all;
  };
  const std::string first = events(7);
  EXPECT_NE(first.find("Cube"), std::string::npos);
  EXPECT_EQ(first, events(7));
  EXPECT_NE(first, events(8));
}

TEST(ObjectRecognition, SurvivesFramesThatCannotBeRead) {
  services::Bench bench;
  auto& service = bench.host.declare("obj_rec", "ObjectRecognition", bench.queue);
  auto made = std::make_unique<ObjectRecognition>(service, demo_parts());
  ObjectRecognition& recognition = *made;
  bench.host.attach("obj_rec", std::move(made));
  bench.call("obj_rec", "start");
  const auto give = [&](Value header, std::size_t bytes) {
    auto packet = std::make_shared<services::Packet>();
    packet->header = std::move(header);
    packet->bytes.resize(bytes);
    recognition.packet("camera", "frame", packet);
  };
  const Dict good{
      {"encoding", "depth16_mm+rgb8"}, {"width", 2}, {"height", 2}, {"fx", 2.0}, {"fy", 2.0}, {"cx", 0.5}, {"cy", 0.5}};
  give(nullptr, 0);
  give(good, 19);
  for (const auto& [key, value] : std::vector<std::pair<std::string, Value>>{
           {"encoding", "jpeg"}, {"width", -1}, {"height", 1e9}, {"fx", 0}, {"cy", "middle"}}) {
    Dict bad = good;
    bad.set(key, value);
    give(bad, 20);
  }
  EXPECT_EQ(bench.log.size(), 7U);
  give(good, 20);
  bench.pass(0.2);
  EXPECT_EQ(bench.log.size(), 7U);
  EXPECT_EQ(bench.deliveries.back().name, "recognized_objects");
  bench.host.stop();
}

}  // namespace
}  // namespace race::recognition
