// PictureRecorder: what a camera shows to others is kept while a run is running.
#include "server/runs/picture_recorder.h"

#include <SQLiteCpp/Database.h>
#include <gmock/gmock.h>

#include "server/runs/jpeg.h"
#include "services/encodings.h"
#include "services/host/work_queue.h"
#include "services/sqlite/file.h"
#include "services/sqlite/write_transaction.h"
#include "tests/unit/server/running_cores.h"
#include "tests/unit/services/host/bench.h"

namespace race::server {
namespace {

using testing::ElementsAre;

/// Publishes what a test tells it, on the flow `water` of a tap.
class Camera final : public services::Component {
 public:
  explicit Camera(services::ServiceHost& host) : host_(host) {}
  const rsm::Service& model() const override { return services::tap_model(); }
  void call(const services::Call&) override {}
  void show(services::Time time, std::string_view encoding = services::kDepthAndColour) {
    Value header = Dict{{"width", 4}, {"height", 2}, {"encoding", std::string(encoding)}, {"time", time}};
    host_.publish("water", std::make_shared<services::Packet>(services::Packet{
                               time, header.freeze(), std::vector<std::byte>(4 * 2 * 5, std::byte{90})}));
  }

 private:
  services::ServiceHost& host_;
};

struct PictureRecorderTest : RunningCores {
  Camera& camera() {
    services::ServiceHost& declared = host.declare("camera", "tap", queue);
    auto made = std::make_unique<Camera>(declared);
    Camera& camera = *made;
    host.attach("camera", std::move(made));
    host.watch("camera", "water", [](const services::PacketPtr&) {});  // somebody looks
    return camera;
  }
  std::vector<double> times(RunId run) {
    std::vector<double> times;
    const auto list = pictures->list(run).value();
    for (const NumberedPicture& each : list) times.push_back(each.picture.time);
    return times;
  }

  services::WorkQueue queue;
  std::unique_ptr<Pictures> pictures = Pictures::open(store.folder.store()).value();
  PictureRecorder::Log no_log = [](LogLevel, const std::string& text) { ADD_FAILURE() << text; };
};

TEST_F(PictureRecorderTest, KeepsTwoPicturesASecondOfWhatPasses) {
  Camera& shown = camera();
  PictureRecorder recorder{host, cores, *pictures, no_log};
  recorder.connect();
  const RunId run = running_core()->run_id();
  for (const double time : {1.0, 1.2, 1.4, 1.6, 2.0, 2.2}) {
    shown.show(time);
    recorder.flush();
  }
  EXPECT_THAT(times(run), ElementsAre(1.0, 1.6, 2.2));
  const Picture picture = pictures->read(run, 0).value();
  EXPECT_EQ(picture.service, "camera");
  EXPECT_EQ(picture.jpeg.substr(0, 4), "/9j/");  // FF D8 FF, as every JPEG begins
}

TEST_F(PictureRecorderTest, AWorldThatBeginsAnewIsKeptFromItsBeginning) {
  Camera& shown = camera();
  PictureRecorder recorder{host, cores, *pictures, no_log};
  recorder.connect();
  const RunId run = running_core()->run_id();
  for (const double time : {50.0, 0.1}) {
    shown.show(time);
    recorder.flush();
  }
  EXPECT_THAT(times(run), ElementsAre(50.0, 0.1));
}

TEST_F(PictureRecorderTest, KeepsNothingWithoutARunOrOfAnotherEncoding) {
  Camera& shown = camera();
  PictureRecorder recorder{host, cores, *pictures, no_log};
  recorder.connect();
  shown.show(1);
  recorder.flush();
  const RunId run = running_core()->run_id();
  shown.show(2, services::kPointsAndColour);
  recorder.flush();
  EXPECT_TRUE(times(run).empty());
}

TEST_F(PictureRecorderTest, HoldsABoundedNumberOfPacketsWhileTheDiskTakesNone) {
  Camera& shown = camera();
  PictureRecorder recorder{host, cores, *pictures, no_log};
  recorder.connect();
  const RunId run = running_core()->run_id();
  const auto file = sqlite::open(store.folder.store());
  auto busy = std::make_unique<sqlite::WriteTransaction>(*file);
  for (int i = 0; i < 100; ++i) shown.show(i);
  busy.reset();
  recorder.flush();
  EXPECT_GE(times(run).size(), 1U);
  EXPECT_LE(times(run).size(), PictureRecorder::kMostWaiting);
}

TEST(Jpeg, IsMadeOfPixelsThatFit) {
  EXPECT_TRUE(jpeg(std::string(4 * 2 * 3, 'a'), 4, 2));
  EXPECT_FALSE(jpeg(std::string(4 * 2 * 3 - 1, 'a'), 4, 2));
  EXPECT_FALSE(jpeg("", 0, 0));
}

}  // namespace
}  // namespace race::server
