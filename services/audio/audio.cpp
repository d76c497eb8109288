#include "services/audio/audio.h"

#include <utility>

#include "services/audio/sounds.h"

namespace race::audio {
namespace {

/// The error response of a play whose argument the speakers do not take.
Value argument_error(std::string_view code, const std::string& message, std::string_view argument) {
  Value error = services::error_value(code, message);
  error.mutable_dict().set("argument", Value(argument));
  return error;
}

}  // namespace

Audio::Audio(display::Speakers& speakers, services::ServiceHost& host)
    : TableComponent(operations(), host), speakers_(speakers) {}

void Audio::play(const services::Call& call, const Dict& arguments) {
  const std::string& sound = arguments.find("sound")->as_string();
  const std::string& target = arguments.find("display")->as_string();
  const auto repeat = arguments.find("repeat")->as_integer();
  const auto known = sounds().find(sound);
  if (known == sounds().end())
    return refuse(call, argument_error("unknown_sound", "there is no sound `" + sound + "`", "sound"));
  const auto started =
      speakers_.play(target, {0, sound, arguments.find("volume")->to_double(), static_cast<int>(repeat)});
  if (!started) return refuse(call, argument_error("no_speaker", started.error().message, "display"));
  drop("replaced", "replaced", "another sound took its place");
  accept(call);
  playing_ = Playing{call.id, sound, host().now(), known->second * static_cast<double>(repeat)};
}

void Audio::stop(const services::Call& call) {
  speakers_.silence();
  if (const auto playing = std::exchange(playing_, std::nullopt))
    host().error(playing->call, services::error_value("stopped", "the sound was stopped"));
  host().result(call.id, nullptr);
}

void Audio::step() {
  if (!playing_) return;
  const display::Playback playback = speakers_.playback();
  const bool over = host().now() - playing_->started >= playing_->length + kMargin;
  if (playback.waiting == 0 || over) finish(playback);
}

// A display that does not report in time counts as disconnected.
void Audio::finish(const display::Playback& playback) {
  speakers_.silence();
  if (playback.reported.empty())
    return drop("fail", "speaker_lost", "no display has reported that it played the sound");
  List displays(playback.reported.begin(), playback.reported.end());
  const Playing playing = *std::exchange(playing_, std::nullopt);
  const Value outcome = Dict{{"sound", Value(playing.sound)}, {"displays", std::move(displays)}};
  take("finish");
  host().result(playing.call, outcome);
  host().event("finished", outcome);
}

// Ends the sound that is playing, if there is one, with an error.
void Audio::drop(std::string_view transition, std::string_view code, std::string_view message) {
  const auto playing = std::exchange(playing_, std::nullopt);
  if (!playing) return;
  take(transition);
  host().error(playing->call, services::error_value(code, message));
}

}  // namespace race::audio
