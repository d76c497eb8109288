// Operator: goes through an operator script on world time. It sees what anybody at the cell sees: states that become
// active, ports that fire, events, displays; and acts by hands and answers alone.
//
// Threads: what happens is told on any; step() on the group's. With everything on one thread, the same run is the same.
#pragma once

#include <deque>
#include <functional>
#include <map>
#include <set>
#include <string>

#include "server/cell/cell_world.h"
#include "server/cell/operator_script.h"
#include "services/clock.h"
#include "services/display/screens.h"
#include "services/host/host.h"
#include "services/mutex.h"

namespace race::server {

class Operator {
 public:
  static constexpr double kDisplayPeriod = 0.02;  // s between two looks at the displays
  static constexpr double kSoundDuration = 0.5;   // s until a sound counts as heard

  /// A line for people: what was done, or why not. Called on any thread, as a world elsewhere answers on its own.
  using Log = std::function<void(const std::string& text)>;

  /// `screens` outlives the operator.
  Operator(OperatorScript script, display::Screens& screens, Log log);
  ~Operator();
  Operator(const Operator&) = delete;
  Operator& operator=(const Operator&) = delete;

  /// The script begins (anew) with the next step.
  void begin() EXCLUDES(mutex_);

  /// Of a core's state: nodes that became active or inactive, ports that fired (as schemas/core_delta.json).
  void changed(const std::string& core, const Dict& active, const List& fired) EXCLUDES(mutex_);
  /// The nodes that are active now.
  void state(const std::string& core, const List& active) EXCLUDES(mutex_);
  /// The core was removed.
  void removed(const std::string& core) EXCLUDES(mutex_);
  void happened(const services::Delivery& event) EXCLUDES(mutex_);

  /// How many nodes of cores it remembers.
  std::size_t remembered() const EXCLUDES(mutex_);

  /// Acts as of `now`. Before each step of the world.
  void step(services::Time now, CellWorld& world) EXCLUDES(mutex_);

 private:
  /// An act of the script whose turn it is.
  struct Waiting {
    std::size_t act = 0;
    services::Time since = 0;
    int seen = 0;
    std::optional<services::Time> met = {};
    std::string display = {}, shown = {};  // where it was seen last, and what
  };

  void note(const std::function<bool(const When&)>& fits) REQUIRES(mutex_);
  void set_active(const std::string& core, const std::string& path, bool on) REQUIRES(mutex_);
  Waiting wait_for(std::size_t act, services::Time now, bool anew) const REQUIRES(mutex_);
  void next(services::Time now) REQUIRES(mutex_);
  void look() REQUIRES(mutex_);
  void look(Waiting& waiting, const display::Content& content) REQUIRES(mutex_);
  void hear(services::Time now) REQUIRES(mutex_);
  bool due(Waiting& waiting, services::Time now) const REQUIRES(mutex_);
  void act(const Waiting& waiting, CellWorld& world);
  void answer(const AnswerCommand& act, const Waiting& waiting);

  const OperatorScript script_;
  display::Screens& screens_;
  const Log log_;
  const std::set<std::string> named_;  // nodes
  std::map<std::string, display::Screens::ConnectionId> displays_;

  mutable services::Mutex mutex_;
  bool begins_ GUARDED_BY(mutex_) = false, running_ GUARDED_BY(mutex_) = false;
  services::Time start_ GUARDED_BY(mutex_) = 0;
  std::vector<Waiting> waiting_
      GUARDED_BY(mutex_);  // those that act always, then the one of the sequence, if one is left
  // Of the nodes that the script names: those that are active, by core, and those that were once.
  std::map<std::string, std::set<std::string>> active_ GUARDED_BY(mutex_);
  std::set<std::string> left_ GUARDED_BY(mutex_);
  services::Time looked_ GUARDED_BY(mutex_) = 0;
  struct Heard {
    services::Time since;
    std::uint64_t sound;
  };
  std::map<std::string, Heard> sounds_ GUARDED_BY(mutex_);  // by display: the one that is played
};

}  // namespace race::server
