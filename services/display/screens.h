// Screens: the displays by name, what each shows, and their input until the services take it. The services `display`
// and `audio` write to it; browsers (through the server's stream), operator scripts and tests show its content.
//
// A display is connected while at least one connection has its name; connections of one name show the same. A display
// keeps its content when its last connection ends, and shows it again after a reconnect. The name "all" (kAllDisplays)
// means every display, also one that connects later.
//
// A display may be at a place, such as `gripper`: that of its newest connection that names one; while it is not
// connected, where it was. "@gripper" means every display at that place, also one that comes there later: what was
// shown last by its name, at its place or everywhere is what it shows.
//
// A client (such as an operator script) connects once and then, on any thread:
//
//   const auto me = screens.connect("main", true);           // ConnectionId: it also makes sounds
//   const auto shown = screens.content("main");              // what to react to
//   if (shown && shown->question) screens.answer("main", "Continue");
//   if (shown && shown->sound) screens.played(*me, shown->sound->id);
//
// Answers reach the service at the next step of its group, in order: in fast mode the same answers at the same world
// time give the same run.
//
// Threads: any. The watcher is called under the lock, in the order of changes: it must be quick and must not call back.
#pragma once

#include <atomic>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/value/expected.h"
#include "core/value/value.h"
#include "services/display/content.h"
#include "services/display/display_backend.h"
#include "services/mutex.h"

namespace race::display {

inline constexpr std::string_view kAllDisplays = "all";

/// Letters, digits, `_` and `-`, 1 to 32 of them, and not "all". Places have such names, too.
bool is_display_name(std::string_view name);
/// "all", the name of a display, or `@` and the name of a place.
bool is_display_target(std::string_view target);

/// Sees what displays show.
class Watcher {
 public:
  virtual ~Watcher() = default;
  /// The whole of what a display shows now.
  virtual void changed(const Content& content) = 0;
  /// The display has no connection and its place was needed.
  virtual void forgotten(const std::string& display) = 0;
};

class Screens final : public DisplayBackend, public Speakers {
 public:
  using ConnectionId = std::uint64_t;
  static constexpr std::size_t kDisplays = 64;           // names that are remembered, and places
  static constexpr std::size_t kMaxPendingEvents = 256;  // that wait for the service

  Screens() = default;
  Screens(const Screens&) = delete;
  Screens& operator=(const Screens&) = delete;

  // ---- For clients that show the content.

  /// A connection of `display`, which may make sounds, at `place` (empty: it names none). Errors: `name`, `conflict`
  /// (kDisplays are connected).
  Expected<ConnectionId> connect(const std::string& display, bool sound, const std::string& place = {});
  void disconnect(ConnectionId connection);
  /// Answers the question that `display` shows: a button's text, or a finite number in its range. With `question` only
  /// if it is the one of that id. The first answer counts; the question is gone with it. Errors: `not_found` (no such
  /// connected display), `conflict` (it does not show the question, or not any more), `type`, `out_of_range`.
  Expected<void> answer(const std::string& display, Value answer, std::optional<std::uint64_t> question = {});
  /// Presses a button of the message that `display` shows. Errors: `not_found`, `conflict`.
  Expected<void> press(const std::string& display, const std::string& button);
  /// The connection has played a sound to its end. Error `conflict`: it is not the sound that is played now.
  Expected<void> played(ConnectionId connection, std::uint64_t sound);

  /// Names of the displays that are connected, in order.
  std::vector<std::string> connected() const;
  /// What a display shows, connected or not; nothing if it is unknown.
  std::optional<Content> content(const std::string& display) const;

  /// From now on `watcher` (nullptr: nobody) is told; it is told nothing after the call that replaced it.
  void watch(Watcher* watcher);
  /// Tells the watcher what `display` shows as if it had changed, in order with real changes.
  void repeat(const std::string& display);

  // ---- For the services (display_backend.h).

  Expected<void> show(const std::string& target, Message message) override;
  Expected<std::uint64_t> ask(const std::string& target, Question question) override;
  Expected<bool> clear(const std::string& target) override;
  void withdraw() override;
  bool asking() override;
  std::vector<DisplayEvent> take() override;
  Expected<std::uint64_t> play(const std::string& target, Sound sound) override;
  void silence() override;
  Playback playback() override;

  /// Changes with each input and connection: while it is the same, the services need not ask again.
  std::uint64_t revision() const { return revision_; }

 private:
  /// What was shown somewhere.
  struct Shown {
    std::optional<Message> message;
    bool without_question = false;  // the question was cleared here
    std::uint64_t order = 0;        // of the last change; the newest counts
  };
  struct Display {
    std::set<ConnectionId> connections;
    std::string place;  // where it is, or was when it was connected last; empty: nowhere in particular
    Shown shown;
  };
  struct Connection {
    std::string display;
    bool sound = false;
    std::string place;
  };

  static bool reaches(const std::string& target, const std::string& name, const Display& display);
  bool update_place(const std::string& name, Display& display) REQUIRES(mutex_);
  Shown* remembered(const std::string& target) REQUIRES(mutex_);
  void forget_a_place() REQUIRES(mutex_);
  Content content_of(const std::string& name, const Display& display) const REQUIRES(mutex_);
  void notify_watcher(const std::string& target) const REQUIRES(mutex_);
  bool make_room() REQUIRES(mutex_);
  Expected<Display*> find_connected(const std::string& display) REQUIRES(mutex_);
  Expected<void> require_connected(const std::string& target) const REQUIRES(mutex_);
  static constexpr std::size_t kNamed = 8;  // displays, or places, that a message names
  /// For people: that no display of this target is connected, and what to do.
  std::string absent(const std::string& target) const REQUIRES(mutex_);
  Expected<void> enqueue(DisplayEvent event) REQUIRES(mutex_);
  bool shows_question(const std::string& name, const Display& display) const REQUIRES(mutex_);

  mutable services::Mutex mutex_;
  Watcher* watcher_ GUARDED_BY(mutex_) = nullptr;
  std::map<std::string, Display> displays_ GUARDED_BY(mutex_);
  std::map<ConnectionId, Connection> connections_ GUARDED_BY(mutex_);
  std::vector<DisplayEvent> events_ GUARDED_BY(mutex_);
  Shown everywhere_ GUARDED_BY(mutex_);                     // what a new display shows
  std::map<std::string, Shown> places_ GUARDED_BY(mutex_);  // what one that comes to a place shows, if that is newer
  std::optional<Question> question_ GUARDED_BY(mutex_);
  std::string question_target_ GUARDED_BY(mutex_);
  std::optional<Sound> sound_ GUARDED_BY(mutex_);
  std::string sound_target_ GUARDED_BY(mutex_);
  std::set<ConnectionId> playing_ GUARDED_BY(mutex_);
  std::set<std::string> played_ GUARDED_BY(mutex_);
  std::uint64_t next_id_ GUARDED_BY(mutex_) = 1;
  std::atomic<std::uint64_t> revision_{0};
};

}  // namespace race::display
