#include "services/audio/remote_speakers.h"

#include <utility>

#include "services/arguments.h"
#include "services/audio/audio.h"
#include "services/audio/sounds.h"

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

Expected<Value> answer_play(display::Speakers& speakers, const Dict& arguments) {
  const services::Call call{0, "play", {}, arguments};
  ASSIGN_OR_RETURN(const Dict bound, services::bind_arguments(*services::find_operation(model(), "play"), call));
  const std::string& sound = bound.find("sound")->as_string();
  if (!sounds().contains(sound)) return unexpected(ErrorCode::not_found, "there is no sound `" + sound + "`", "sound");
  const int repeat = static_cast<int>(bound.find("repeat")->as_integer());
  const auto id =
      speakers.play(bound.find("display")->as_string(), {0, sound, bound.find("volume")->to_double(), repeat});
  return id ? Value(static_cast<std::int64_t>(*id)) : display::refusal(id.error());
}

}  // namespace

Expected<std::uint64_t> RemoteSpeakers::play(const std::string& target, display::Sound sound) {
  news();
  return display::read_id(server_(
      "play", {{"sound", sound.name}, {"volume", sound.volume}, {"repeat", sound.repeat}, {"display", target}}));
}

void RemoteSpeakers::silence() {
  news();
  (void)server_("silence", {});
}

// Without an answer nobody has reported yet: the sound is waited for.
display::Playback RemoteSpeakers::playback() {
  if (playback_) return *playback_;
  if (const auto answer = server_("playback", {})) playback_ = read_playback(*answer);
  return playback_.value_or(display::Playback{1, {}});
}

Expected<Value> answer_speakers(display::Speakers& speakers, std::string_view function, const Dict& arguments) {
  if (function == "play") return answer_play(speakers, arguments);
  if (auto none = display::need_none(function, arguments); !none) return tl::unexpected(std::move(none).error());
  if (function == "silence") {
    speakers.silence();
    return Value();
  }
  if (function == "playback") {
    const display::Playback playback = speakers.playback();
    return Value(Dict{{"waiting", static_cast<std::int64_t>(playback.waiting)},
                      {"reported", List(playback.reported.begin(), playback.reported.end())}});
  }
  return unexpected(ErrorCode::not_found, "an audio's speakers have no such function", std::string(function));
}

}  // namespace race::audio
