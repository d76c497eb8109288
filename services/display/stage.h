// Stage and Speakers: what the services `display` and `audio` see of those who show: the Screens, in their own process
// or in the server's (RemoteStage, services/audio/remote_speakers.h). The components are the same code on both.
//
// Threads: the component's.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/value/expected.h"
#include "core/value/value.h"
#include "services/display/content.h"

namespace race::display {

/// What somebody did, for the service `display`.
struct Happening {
  enum class Kind : std::uint8_t { answered, pressed, connected, disconnected } kind = Kind::pressed;
  std::string display;
  Value value = {};            // the answer, or the button
  std::uint64_t question = 0;  // that was answered
  bool operator==(const Happening&) const = default;
};

/// How far a sound is, for the service `audio`.
struct Playback {
  std::size_t waiting = 0;            // connections that have not reported yet
  std::vector<std::string> reported;  // displays that have played it, by name
};

// `target`: a display's name, or "all" (kEvery). Error `not_found`, with the path `display`: it is not connected, or
// none is. Where the Screens are the server's, `unavailable`: the connection to it has ended.

/// Asks the server of the Screens and waits for its answer. Error `unavailable`: the connection has ended.
using AskServer = std::function<Expected<Value>(std::string_view function, Dict arguments)>;

/// Of `display`.
class Stage {
 public:
  virtual ~Stage() = default;
  virtual Expected<void> show(const std::string& target, Message message) = 0;
  /// A new question takes the place of the one that waits, everywhere. Gives its id.
  virtual Expected<std::uint64_t> ask(const std::string& target, Question question) = 0;
  /// Takes the message away, and the question if it is shown there; whether no display is left that shows it, so that
  /// there is none any more.
  virtual Expected<bool> clear(const std::string& target) = 0;
  /// Takes the question away everywhere.
  virtual void withdraw() = 0;
  /// Whether a connected display shows the question.
  virtual bool asking() = 0;
  /// What happened since it was taken last, in order.
  virtual std::vector<Happening> take() = 0;
};

/// Of `audio`.
class Speakers {
 public:
  virtual ~Speakers() = default;
  /// Starts a sound on all connections of `target` that may make sounds, in place of one that is played. `not_found`:
  /// there is none.
  virtual Expected<std::uint64_t> play(const std::string& target, Sound sound) = 0;
  virtual void silence() = 0;
  virtual Playback playback() = 0;
};

}  // namespace race::display
