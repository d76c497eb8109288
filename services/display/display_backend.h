// DisplayBackend and Speakers: the interfaces by which the components `display` and `audio` reach the displays. Screens
// implements both within the server; RemoteDisplayBackend and RemoteSpeakers (services/audio/remote_speakers.h)
// implement them in a process of its own, by requests to the server.
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

/// What happened at a display: input of a person, or a change of its connection.
struct DisplayEvent {
  enum class Kind : std::uint8_t { answered, pressed, connected, disconnected } kind = Kind::pressed;
  std::string display;
  Value value = {};            // the answer, or the button
  std::uint64_t question = 0;  // that was answered
  std::string place = {};      // of `connected` and `disconnected`: where the display is, or was; empty: nowhere
  bool operator==(const DisplayEvent&) const = default;
};

/// The progress of a sound.
struct Playback {
  std::size_t waiting = 0;            // connections that have not reported yet
  std::vector<std::string> reported;  // displays that have played it, by name
};

// `target`: a display's name, `@` and a place, or "all" (kAllDisplays). Error `not_found`, with the path `display`: it
// is not connected, or none is. Where the Screens are the server's, `unavailable`: the connection to it has ended.

/// Sends a request to the server that has the Screens and waits for its answer. Error `unavailable`: the connection has
/// ended.
using ServerRequest = std::function<Expected<Value>(std::string_view function, Dict arguments)>;

/// Used by `display`.
class DisplayBackend {
 public:
  virtual ~DisplayBackend() = default;
  virtual Expected<void> show(const std::string& target, Message message) = 0;
  /// Replaces the question that waits, on all displays. Returns the id of the new one.
  virtual Expected<std::uint64_t> ask(const std::string& target, Question question) = 0;
  /// Removes the message, and the question if it is shown there. Returns whether the question was dropped because no
  /// display shows it any more.
  virtual Expected<bool> clear(const std::string& target) = 0;
  /// Removes the question from all displays.
  virtual void withdraw() = 0;
  /// Whether a connected display shows the question.
  virtual bool asking() = 0;
  /// The events since the last call, in order.
  virtual std::vector<DisplayEvent> take() = 0;
};

/// Used by `audio`.
class Speakers {
 public:
  virtual ~Speakers() = default;
  /// Starts a sound on all connections of `target` that may make sounds; it replaces one that is playing. Error
  /// `not_found`: there is no such connection.
  virtual Expected<std::uint64_t> play(const std::string& target, Sound sound) = 0;
  virtual void silence() = 0;
  virtual Playback playback() = 0;
};

}  // namespace race::display
