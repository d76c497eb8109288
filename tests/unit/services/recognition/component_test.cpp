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
using testing::UnorderedElementsAre;

/// Camera and recognition of the demonstrator, with time that passes and a world that stands still.
struct Fixture {
  explicit Fixture(std::uint64_t seed = 1, bool has_camera = true) : world(build(demo_scene())) {
    auto& eye = bench.host.declare("camera", "KinectDriver", bench.queue);
    if (has_camera) bench.host.attach("camera", std::make_unique<camera::Camera>(eye, *world, seed));
    auto& mind = bench.host.declare("obj_rec", "ObjectRecognition", bench.queue);
    bench.host.attach("obj_rec", std::make_unique<ObjectRecognition>(mind, demo_parts()));
  }
  ~Fixture() { bench.host.stop(); }
  /// The labels of each event so far.
  std::vector<std::vector<std::string>> labels() const {
    std::vector<std::vector<std::string>> all;
    for (const auto& delivery : bench.deliveries) {
      if (delivery.kind == services::Delivery::Kind::event) all.push_back(labels_of(delivery.data));
    }
    return all;
  }
  /// The same of each result of `look`.
  std::vector<std::vector<std::string>> looks() const {
    std::vector<std::vector<std::string>> all;
    for (const auto& delivery : bench.deliveries) {
      if (delivery.kind == services::Delivery::Kind::response && delivery.name == "look" && !delivery.is_error)
        all.push_back(labels_of(delivery.data));
    }
    return all;
  }
  /// Whether the camera makes pictures for somebody.
  bool has_demand() const { return bench.host.service("obj_rec")->subscribes.front().listening; }
  static std::vector<std::string> labels_of(const Value& picture) {
    std::vector<std::string> labels;
    for (const Value& object : picture.find("objects")->as_list()) labels.push_back(object.find("label")->as_string());
    return labels;
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

TEST(ObjectRecognition, LooksOnceForAllPartsWhileItIsIdle) {
  Fixture fixture;
  fixture.bench.call("obj_rec", "look");
  EXPECT_TRUE(fixture.has_demand());
  fixture.bench.pass(0.5);
  EXPECT_THAT(fixture.looks(), ElementsAre(UnorderedElementsAre("Cube", "Box", "Block", "Tape", "Bar", "Tool")));
  EXPECT_THAT(fixture.labels(), IsEmpty()) << "it was not started";
  EXPECT_FALSE(fixture.has_demand());
  EXPECT_EQ(fixture.bench.host.service("obj_rec")->state, "Idle");
  EXPECT_THAT(fixture.bench.violations("obj_rec"), IsEmpty());
}

TEST(ObjectRecognition, AnswersALookWithWhatAStartLooksForAndGoesOn) {
  Fixture fixture;
  fixture.bench.call("obj_rec", "start", {List{Value("Tape")}});
  fixture.bench.call("obj_rec", "look");
  fixture.bench.pass(0.45);
  EXPECT_THAT(fixture.looks(), ElementsAre(ElementsAre("Tape")));
  EXPECT_THAT(fixture.labels(), ElementsAre(ElementsAre("Tape"), ElementsAre("Tape"))) << "as without a look";
  EXPECT_EQ(fixture.bench.host.service("obj_rec")->state, "Recognizing");
  EXPECT_TRUE(fixture.has_demand());
  EXPECT_THAT(fixture.bench.violations("obj_rec"), IsEmpty());
}

TEST(ObjectRecognition, AnswersEachOfSeveralLooksByItself) {
  Fixture fixture;
  for (int i = 0; i < 3; ++i) fixture.bench.call("obj_rec", "look");
  fixture.bench.pass(0.5);
  EXPECT_EQ(fixture.looks().size(), 3U);
  EXPECT_THAT(fixture.bench.violations("obj_rec"), IsEmpty());
}

TEST(ObjectRecognition, AnswersALookWithAPictureThatWasTakenAfterIt) {
  Fixture fixture;
  fixture.bench.call("obj_rec", "start");
  for (int i = 0; i < 8; ++i) {
    fixture.bench.pass(0.06);  // at any moment of the picture that is being processed
    const double asked = fixture.bench.milliseconds / 1000.0;
    fixture.bench.deliveries.clear();
    fixture.bench.call("obj_rec", "look");
    fixture.bench.pass(0.6);
    ASSERT_EQ(fixture.looks().size(), 1U);
    for (const auto& delivery : fixture.bench.deliveries) {
      if (delivery.name != "look") continue;
      EXPECT_GE(delivery.data.find("time")->to_double(), asked);
    }
  }
}

TEST(ObjectRecognition, EndsALookWhenItIsStartedOrStopped) {
  for (const char* operation : {"start", "stop"}) {
    Fixture fixture;
    fixture.bench.call("obj_rec", "look");
    fixture.bench.call("obj_rec", operation);
    EXPECT_THAT(fixture.bench.responses(),
                ElementsAre("obj_rec.look !> interrupted", std::string("obj_rec.") + operation + " -> null"));
    fixture.bench.pass(0.5);
    EXPECT_THAT(fixture.looks(), IsEmpty());
    EXPECT_EQ(fixture.labels().empty(), operation == std::string("stop"));
    EXPECT_THAT(fixture.bench.violations("obj_rec"), IsEmpty());
  }
}

TEST(ObjectRecognition, EndsALookAlsoByAStartThatIsRefused) {
  Fixture fixture;
  fixture.bench.call("obj_rec", "look");
  fixture.bench.call("obj_rec", "start", {List{}});
  EXPECT_THAT(fixture.bench.responses(), ElementsAre("obj_rec.look !> interrupted", "obj_rec.start !> out_of_range"));
  EXPECT_FALSE(fixture.has_demand());
  EXPECT_THAT(fixture.bench.violations("obj_rec"), IsEmpty());
}

TEST(ObjectRecognition, SaysOfALookThatNoPictureHasCome) {
  for (const bool is_started : {false, true}) {
    Fixture fixture(1, false);
    if (is_started) fixture.bench.call("obj_rec", "start");
    fixture.bench.deliveries.clear();
    fixture.bench.call("obj_rec", "look");
    fixture.bench.pass(1.9);
    EXPECT_THAT(fixture.bench.responses(), IsEmpty());
    fixture.bench.pass(0.2);
    EXPECT_THAT(fixture.bench.responses(), ElementsAre("obj_rec.look !> no_picture"));
    EXPECT_EQ(fixture.has_demand(), is_started);
    EXPECT_EQ(fixture.bench.host.service("obj_rec")->state, is_started ? "Recognizing" : "Idle");
    EXPECT_THAT(fixture.bench.violations("obj_rec"), IsEmpty());
  }
}

TEST(ObjectRecognition, NeedsNoPictureForALookThatNobodyWaitsFor) {
  Fixture fixture;
  fixture.bench.call("obj_rec", "look");
  fixture.bench.host.abandon({"1", fixture.bench.calls});
  fixture.bench.queue.run();
  EXPECT_FALSE(fixture.has_demand());
  EXPECT_THAT(fixture.bench.responses(), ElementsAre("obj_rec.look !> abandoned"));
  EXPECT_THAT(fixture.bench.violations("obj_rec"), IsEmpty());
}

TEST(ObjectRecognition, KnowsTheLabelsOfAllPartsInEveryState) {
  Fixture fixture;
  fixture.bench.call("obj_rec", "labels");
  fixture.bench.call("obj_rec", "start", {List{Value("Tape")}});
  fixture.bench.call("obj_rec", "labels");
  const std::string all = R"(obj_rec.labels -> ["Cube","Box","Block","Tape","Bar","Tool"])";
  EXPECT_THAT(fixture.bench.responses(), ElementsAre(all, "obj_rec.start -> null", all));
  EXPECT_THAT(fixture.bench.violations("obj_rec"), IsEmpty());
}

// So they need no controls, and are no matter of who has them.
TEST(ObjectRecognition, SaysThatLooksAndLabelsChangeNothing) {
  for (const rsm::Operation& operation : model().operations)
    EXPECT_EQ(operation.reads, operation.name == "look" || operation.name == "labels") << operation.name;
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
