// RemoteSpeakers: the Speakers of an `audio` component that runs in its own process. It sends requests to the server,
// which answers them with answer_audio_request(): `play`, with the parameters of the operation, `silence` and
// `playback` without arguments. RemoteDisplayBackend (services/display/remote_display_backend.h) does the same for
// `display`.
//
// Threads: the component's; answer_audio_request() any.
#pragma once

#include <optional>
#include <string_view>

#include "services/display/display_backend.h"

namespace race::audio {

class RemoteSpeakers final : public display::Speakers {
 public:
  explicit RemoteSpeakers(display::ServerRequest server) : server_(std::move(server)) {}

  /// Discards the cached playback: a display has reported, connected or disconnected.
  void invalidate() { playback_.reset(); }

  Expected<std::uint64_t> play(const std::string& target, display::Sound sound) override;
  void silence() override;
  display::Playback playback() override;

 private:
  display::ServerRequest server_;
  std::optional<display::Playback> playback_;  // cached; nothing: to be requested
};

/// Answers a request by `speakers`. Their refusal (`not_found`) is an answer; errors: a request that no component
/// makes.
Expected<Value> answer_audio_request(display::Speakers& speakers, std::string_view function, const Dict& arguments);

}  // namespace race::audio
