#include "services/audio/audio.h"

#include <gmock/gmock.h>

#include <limits>
#include <tuple>
#include <utility>

#include "core/value/json.h"
#include "services/audio/remote_speakers.h"
#include "services/audio/sounds.h"
#include "tests/unit/services/display/screens_bench.h"

namespace race::audio {
namespace {

using display::Screens;
using services::Delivery;
using testing::ElementsAre;
using testing::IsEmpty;

struct AudioTest : display::ScreensBench<RemoteSpeakers> {
  explicit AudioTest(bool elsewhere) : ScreensBench("audio", answer_audio_request) {
    bench.add<Audio>("audio", elsewhere ? static_cast<display::Speakers&>(remote) : screens);
  }
  Screens::ConnectionId connect(const std::string& display, bool sound = true) {
    return screens.connect(display, sound).value();
  }
  std::optional<display::Sound> sound(const std::string& display) { return screens.content(display)->sound; }
  void played(Screens::ConnectionId connection, const std::string& display) {
    ASSERT_TRUE(screens.played(connection, sound(display)->id));
    pass(0.001);
  }
  int finished() const {
    int count = 0;
    for (const Delivery& each : bench.deliveries) count += each.kind == Delivery::Kind::event;
    return count;
  }
};

/// Correct calls: the monitor must find no violation.
struct AudioInOrder : AudioTest, testing::WithParamInterface<bool> {
  AudioInOrder() : AudioTest(GetParam()) {}
  ~AudioInOrder() override {
    for (const auto& violation : bench.violations("audio")) ADD_FAILURE() << violation.rule << violation.message;
  }
};

TEST(Sounds, EndWithTheirLastNote) {
  EXPECT_EQ(sounds().at("beep"), 0.15);
  EXPECT_NEAR(sounds().at("success"), 0.7, 1e-12);
  for (const auto& [name, length] : sounds()) EXPECT_GT(length, 0) << name;
}

TEST_P(AudioInOrder, WithoutADisplayThatMakesSoundsPlayIsAnsweredNoSpeaker) {
  call("play", {"beep"});
  connect("mute", false);
  call("play", {"beep"});
  connect("left");
  call("play", {"beep"}, {{"display", "right"}});
  EXPECT_THAT(bench.responses(),
              ElementsAre("audio.play !> no_speaker", "audio.play !> no_speaker", "audio.play !> no_speaker"));
}

TEST_P(AudioInOrder, AnUnknownSoundIsAnError) {
  connect("main");
  call("play", {"trumpet"});
  EXPECT_THAT(bench.responses(), ElementsAre("audio.play !> unknown_sound"));
  EXPECT_EQ(bench.deliveries.back().data.find("argument")->as_string(), "sound");
  EXPECT_FALSE(sound("main"));
}

TEST_P(AudioInOrder, AnswersWhenTheDisplayReportsTheEnd) {
  const auto main = connect("main");
  call("play", {"beep"}, {{"volume", 0.5}, {"repeat", 3}});
  EXPECT_EQ(sound("main")->name, "beep");
  EXPECT_EQ(sound("main")->volume, 0.5);
  EXPECT_EQ(sound("main")->repeat, 3);
  pass(0.5);
  EXPECT_THAT(bench.responses(), IsEmpty());
  played(main, "main");
  EXPECT_THAT(bench.responses(), ElementsAre(R"(audio.play -> {"sound":"beep","displays":["main"]})"));
  EXPECT_EQ(finished(), 1);
  EXPECT_FALSE(sound("main"));
}

TEST_P(AudioInOrder, WaitsForAllDisplaysThatPlayIt) {
  const auto left = connect("left"), right = connect("right");
  connect("mute", false);
  call("play", {"beep"});
  played(right, "right");
  EXPECT_THAT(bench.responses(), IsEmpty());
  played(left, "left");
  EXPECT_THAT(bench.responses(), ElementsAre(R"(audio.play -> {"sound":"beep","displays":["left","right"]})"));
}

TEST_P(AudioInOrder, ADisplayThatNeverReportsIsNotWaitedForLongerThanTheSoundAndAMargin) {
  connect("main");
  const double length = 2 * sounds().at("success");
  call("play", {"success", 1, 2});
  pass(length + Audio::kMargin - 0.01);
  EXPECT_THAT(bench.responses(), IsEmpty());
  pass(0.02);
  EXPECT_THAT(bench.responses(), ElementsAre("audio.play !> speaker_lost"));
  EXPECT_FALSE(sound("main"));
  EXPECT_EQ(finished(), 0);
}

TEST_P(AudioInOrder, OneDisplayThatReportsIsEnoughInTheEnd) {
  const auto left = connect("left");
  connect("right");
  call("play", {"beep"});
  played(left, "left");
  pass(sounds().at("beep") + Audio::kMargin);
  EXPECT_THAT(bench.responses(), ElementsAre(R"(audio.play -> {"sound":"beep","displays":["left"]})"));
}

TEST_P(AudioInOrder, WhenAllDisplaysThatPlayItHaveGoneThePlayIsLost) {
  const auto left = connect("left");
  call("play", {"beep"});
  screens.disconnect(left);
  pass(0.001);
  EXPECT_THAT(bench.responses(), ElementsAre("audio.play !> speaker_lost"));
}

TEST_P(AudioInOrder, ANewSoundTakesThePlaceOfTheOneThatPlays) {
  const auto main = connect("main");
  call("play", {"beep"});
  const auto first = sound("main")->id;
  call("play", {"error"});
  EXPECT_THAT(bench.responses(), ElementsAre("audio.play !> replaced"));
  EXPECT_FALSE(screens.played(main, first));
  played(main, "main");
  EXPECT_EQ(bench.responses().back(), R"(audio.play -> {"sound":"error","displays":["main"]})");
}

TEST_P(AudioInOrder, ASoundThatCannotBePlayedLeavesTheOneThatPlays) {
  connect("main");
  call("play", {"beep"});
  call("play", {"trumpet"});
  EXPECT_THAT(bench.responses(), ElementsAre("audio.play !> unknown_sound"));
  EXPECT_EQ(sound("main")->name, "beep");
}

TEST_P(AudioInOrder, StopIsSilence) {
  connect("main");
  call("stop");
  call("play", {"collision"});
  call("stop");
  EXPECT_THAT(bench.responses(), ElementsAre("audio.stop -> null", "audio.play !> stopped", "audio.stop -> null"));
  EXPECT_FALSE(sound("main"));
  EXPECT_EQ(*bench.host.service("audio")->state, "Idle");
}

struct Wrong {
  List args;
  std::string code, argument;
};
struct AudioArguments : AudioTest, testing::WithParamInterface<std::tuple<bool, Wrong>> {
  AudioArguments() : AudioTest(std::get<bool>(GetParam())) {}
};

INSTANTIATE_TEST_SUITE_P(HereAndElsewhere, AudioInOrder, testing::Bool());

TEST_P(AudioArguments, AreHeldToTheirLimits) {
  const Wrong& wrong = std::get<Wrong>(GetParam());
  connect("main");
  for (const bool playing : {false, true}) {
    if (playing) call("play", {"done"});
    const auto before = sound("main");
    call("play", wrong.args);
    EXPECT_EQ(bench.responses().back(), "audio.play !> " + wrong.code);
    EXPECT_EQ(bench.deliveries.back().data.find("argument")->as_string(), wrong.argument);
    EXPECT_EQ(sound("main"), before);
  }
  for (const auto& violation : bench.violations("audio")) EXPECT_EQ(violation.rule, "type") << violation.message;
}

INSTANTIATE_TEST_SUITE_P(
    Wrong, AudioArguments,
    testing::Combine(
        testing::Bool(),
        testing::Values(Wrong{{}, "missing", "sound"}, Wrong{{1}, "type", "sound"},
                        Wrong{{"beep", 1.5}, "out_of_range", "volume"}, Wrong{{"beep", -0.1}, "out_of_range", "volume"},
                        Wrong{{"beep", std::numeric_limits<double>::quiet_NaN()}, "out_of_range", "volume"},
                        Wrong{{"beep", "loud"}, "type", "volume"}, Wrong{{"beep", 1, 0}, "out_of_range", "repeat"},
                        Wrong{{"beep", 1, 21}, "out_of_range", "repeat"}, Wrong{{"beep", 1, 1.5}, "type", "repeat"})));

// The server refuses a request that no audio component makes, and plays nothing.
TEST(AnswerSpeakers, RefusesWhatNoAudioAsks) {
  Screens screens;
  ASSERT_TRUE(screens.connect("main", true));
  const auto error = [&](const char* function, const char* arguments) {
    const Value json = parse_json(arguments).value();
    const auto answer = answer_audio_request(screens, function, json.as_dict());
    return answer ? "none" : answer.error().path + ": " + std::string(name(answer.error().code));
  };
  EXPECT_EQ(error("ask", "{}"), "ask: not_found");
  EXPECT_EQ(error("play", "{}"), "sound: missing");
  EXPECT_EQ(error("play", R"({"sound": "trumpet"})"), "sound: not_found");
  EXPECT_EQ(error("play", R"({"sound": "beep", "volume": 2})"), "volume: out_of_range");
  EXPECT_EQ(error("silence", R"({"all": true})"), "arguments: unknown_field");
  EXPECT_FALSE(screens.content("main")->sound);
  EXPECT_EQ(error("play", R"({"sound": "beep"})"), "none");
  EXPECT_TRUE(screens.content("main")->sound);
}

}  // namespace
}  // namespace race::audio
