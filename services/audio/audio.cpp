#include "services/audio/audio.h"

#include <utility>

#include "core/rsm/document.h"
#include "services/arguments.h"
#include "services/audio/sounds.h"

namespace race::audio {
namespace {

// One sound at a time: another one takes its place. A call that is refused takes `refused` at once, or `refuse_play`
// while a sound is played, which goes on.
constexpr std::string_view kModel = R"json({
  "rsm": 1, "name": "audio",
  "operations": [
    {"name": "play", "parameters": [
       {"name": "sound", "type": "string", "doc": "a name of api/sounds.json"},
       {"name": "volume", "type": "number", "min": 0, "max": 1, "value": 1},
       {"name": "repeat", "type": "int", "min": 1, "max": 20, "value": 1, "doc": "times"},
       {"name": "display", "type": "string", "value": "all"}],
     "result": {"record": {"sound": "string", "displays": {"list": "string"}}},
     "error": {"record": {"code": "string", "message": "string", "argument": {"optional": "string"}}},
     "doc": "Answers when the sound is over, with the displays that have played it to its end."},
    {"name": "stop", "safe": true, "doc": "Silence; a play is answered `stopped`."}
  ],
  "events": [
    {"name": "finished", "data": {"record": {"sound": "string", "displays": {"list": "string"}}}, "doc": "A sound was played to its end."}
  ],
  "states": [{"name": "Idle"}, {"name": "Playing"}], "init": "Idle",
  "transitions": [
    {"id": "play", "src": "Idle", "dst": "Playing", "operation": "play", "defer": ["finish", "refused", "fail", "replaced", "stop"]},
    {"id": "refuse_play", "src": "Playing", "dst": "Playing", "operation": "play"},
    {"id": "finish", "src": "Playing", "dst": "Idle", "events": ["finished"]},
    {"id": "refused", "src": "Playing", "dst": "Idle"},
    {"id": "fail", "src": "Playing", "dst": "Idle", "error": "speaker_lost"},
    {"id": "replaced", "src": "Playing", "dst": "Idle", "error": "replaced"},
    {"id": "stop", "src": "Playing", "dst": "Idle", "operation": "stop", "error": "stopped"},
    {"id": "stop_idle", "src": "Idle", "dst": "Idle", "operation": "stop"}
  ]
})json";

}  // namespace

const rsm::Service& model() {
  static const rsm::Service service = rsm::read_service_text(kModel, "services/audio").value();
  return service;
}

Audio::Audio(display::Speakers& speakers, services::ServiceHost& host) : host_(host), speakers_(speakers) {}

void Audio::call(const services::Call& call) {
  if (call.operation == "stop") return stop(call);
  const auto arguments = services::bind_arguments(*services::find_operation(model(), call.operation), call);
  if (!arguments) return refuse(call, services::error_value(arguments.error()), arguments.error().path);
  play(call, *arguments);
}

void Audio::play(const services::Call& call, const Dict& arguments) {
  const std::string& sound = arguments.find("sound")->as_string();
  const std::string& target = arguments.find("display")->as_string();
  const auto repeat = arguments.find("repeat")->as_integer();
  const auto known = sounds().find(sound);
  if (known == sounds().end())
    return refuse(call, services::error_value("unknown_sound", "there is no sound `" + sound + "`"), "sound");
  const auto started =
      speakers_.play(target, {0, sound, arguments.find("volume")->to_double(), static_cast<int>(repeat)});
  if (!started) return refuse(call, services::error_value("no_speaker", started.error().message), "display");
  drop("replaced", "replaced", "another sound took its place");
  host_.transition("play", call.id);
  playing_ = Playing{call.id, sound, host_.now(), known->second * static_cast<double>(repeat)};
}

void Audio::refuse(const services::Call& call, Value error, const std::string& argument) {
  host_.transition(playing_ ? "refuse_play" : "play", call.id);
  if (!playing_) host_.transition("refused");
  if (!argument.empty()) error.mutable_dict().set("argument", Value(argument));
  host_.error(call.id, std::move(error));
}

void Audio::stop(const services::Call& call) {
  speakers_.silence();
  host_.transition(playing_ ? "stop" : "stop_idle", call.id);
  if (const auto playing = std::exchange(playing_, std::nullopt))
    host_.error(playing->call, services::error_value("stopped", "the sound was stopped"));
  host_.result(call.id, nullptr);
}

void Audio::step() {
  if (!playing_) return;
  const display::Playback playback = speakers_.playback();
  const bool over = host_.now() - playing_->started >= playing_->length + kMargin;
  if (playback.waiting == 0 || over) finish(playback);
}

// A display that does not report in time counts as one that has gone.
void Audio::finish(const display::Playback& playback) {
  speakers_.silence();
  if (playback.reported.empty())
    return drop("fail", "speaker_lost", "no display has reported that it played the sound");
  List displays(playback.reported.begin(), playback.reported.end());
  const Playing playing = *std::exchange(playing_, std::nullopt);
  const Value outcome = Dict{{"sound", Value(playing.sound)}, {"displays", std::move(displays)}};
  host_.transition("finish");
  host_.result(playing.call, outcome);
  host_.event("finished", outcome);
}

// The sound that is played, if there is one, will not be finished any more.
void Audio::drop(std::string_view transition, std::string_view code, std::string_view message) {
  const auto playing = std::exchange(playing_, std::nullopt);
  if (!playing) return;
  host_.transition(transition);
  host_.error(playing->call, services::error_value(code, message));
}

}  // namespace race::audio
