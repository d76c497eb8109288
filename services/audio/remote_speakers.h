// RemoteSpeakers: the Speakers of an `audio` in a process of its own; answer_speakers(): what the server does with its
// questions: play, as the operation of the RSM, silence and playback without arguments. As a display's stage
// (services/display/remote_stage.h).
//
// Threads: the component's; answer_speakers() any.
#pragma once

#include <optional>
#include <string_view>

#include "services/display/stage.h"

namespace race::audio {

class RemoteSpeakers final : public display::Speakers {
 public:
  explicit RemoteSpeakers(display::AskServer server) : server_(std::move(server)) {}

  /// A display has reported, come or gone: what was known of it is so no more.
  void news() { playback_.reset(); }

  Expected<std::uint64_t> play(const std::string& target, display::Sound sound) override;
  void silence() override;
  display::Playback playback() override;

 private:
  display::AskServer server_;
  std::optional<display::Playback> playback_;  // as far as it is known
};

/// Asks `speakers`. What they refuse (`not_found`) is a good answer; errors: those of a question that no component
/// asks.
Expected<Value> answer_speakers(display::Speakers& speakers, std::string_view function, const Dict& arguments);

}  // namespace race::audio
