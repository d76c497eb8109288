#include "services/audio/remote_speakers.h"

#include <array>

#include "services/audio/audio.h"
#include "services/audio/sounds.h"
#include "services/host_function.h"

namespace race::audio {
namespace {

std::optional<display::Playback> read_playback(const Value& json) {
  const Value *waiting = json.find("waiting"), *reported = json.find("reported");
  if (!waiting || !waiting->is_integer() || !reported || !reported->is_list()) return std::nullopt;
  display::Playback playback{static_cast<std::size_t>(waiting->as_integer()), {}};
  for (const Value& name : reported->as_list())
    if (name.is_string()) playback.reported.push_back(name.as_string());
  return playback;
}

// ---- Functions that the server answers.

Expected<Value> play(display::Speakers& speakers, const Dict& arguments) {
  const std::string& sound = arguments.find("sound")->as_string();
  if (!sounds().contains(sound)) return unexpected(ErrorCode::not_found, "there is no sound `" + sound + "`", "sound");
  const int repeat = static_cast<int>(arguments.find("repeat")->as_integer());
  const auto id =
      speakers.play(arguments.find("display")->as_string(), {0, sound, arguments.find("volume")->to_double(), repeat});
  return id ? Value(static_cast<std::int64_t>(*id)) : services::refusal_reply(id.error());
}

Expected<Value> silence(display::Speakers& speakers, const Dict&) {
  speakers.silence();
  return Value();
}

Expected<Value> playback(display::Speakers& speakers, const Dict&) {
  const display::Playback now = speakers.playback();
  return Value(Dict{{"waiting", static_cast<std::int64_t>(now.waiting)},
                    {"reported", List(now.reported.begin(), now.reported.end())}});
}

using Function = services::HostFunction<display::Speakers>;

constexpr std::array kFunctions = {Function{"play", play}, Function{"silence", silence, false},
                                   Function{"playback", playback, false}};

}  // namespace

Expected<std::uint64_t> RemoteSpeakers::play(const std::string& target, display::Sound sound) {
  invalidate();
  return services::read_id(server_(
      "play", {{"sound", sound.name}, {"volume", sound.volume}, {"repeat", sound.repeat}, {"display", target}}));
}

void RemoteSpeakers::silence() {
  invalidate();
  (void)server_("silence", {});
}

// Without an answer, no display counts as having reported: the component waits on.
display::Playback RemoteSpeakers::playback() {
  if (playback_) return *playback_;
  if (const auto answer = server_("playback", {})) playback_ = read_playback(*answer);
  return playback_.value_or(display::Playback{1, {}});
}

Expected<Value> answer_audio_request(display::Speakers& speakers, std::string_view function, const Dict& arguments) {
  return services::call_host_function(model(), kFunctions, speakers, function, arguments);
}

}  // namespace race::audio
