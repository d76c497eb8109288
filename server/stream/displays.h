// Displays: the connections of the stream that are displays (schemas/display.json). A connection that announces itself
// is told on the channel display/NAME what that display shows, the whole each time (the channel is sampled), and says
// what people do with it. The content itself lives in display::Screens.
//
// Threads: any.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>

#include "core/value/expected.h"
#include "server/stream/hub.h"
#include "services/display/screens.h"
#include "services/mutex.h"

namespace race::server {

class Displays final : public display::Watcher {
 public:
  /// Both outlive this.
  Displays(display::Screens& screens, Hub& hub);
  ~Displays() override;
  Displays(const Displays&) = delete;
  Displays& operator=(const Displays&) = delete;

  /// The source of a display's channel; nothing if no such display has ever been connected.
  std::optional<Source> source(const std::string& display);

  /// From now on `subscriber` is a connection of the display `name`, which may make sounds (`sound`), at `place`
  /// (empty: it names none), and gets its channel; it is none of another one any more. Errors: those of
  /// Screens::connect.
  Expected<void> announce(const std::shared_ptr<Subscriber>& subscriber, const std::string& name, bool sound,
                          const std::string& place);

  // What a person did on the display that `subscriber` is. Errors: those of Screens; `conflict`: it is none.

  Expected<void> answer(const Subscriber& subscriber, std::uint64_t question, Value answer);
  Expected<void> press(const Subscriber& subscriber, const std::string& button);
  Expected<void> played(const Subscriber& subscriber, std::uint64_t sound);

  /// The subscriber is gone.
  void disconnect(const Subscriber& subscriber);

  void changed(const display::Content& content) override;
  void forgotten(const std::string& display) override;

 private:
  struct Connection {
    display::Screens::ConnectionId id = 0;
    std::string name;
  };
  Expected<Connection> find(const Subscriber& subscriber) const EXCLUDES(mutex_);

  display::Screens& screens_;
  Hub& hub_;
  mutable services::Mutex mutex_;  // locked before that of Screens; callbacks of Screens do not lock it
  std::map<const Subscriber*, Connection> connections_ GUARDED_BY(mutex_);
};

/// schemas/display.json
Value display_json(const display::Content& content);

}  // namespace race::server
