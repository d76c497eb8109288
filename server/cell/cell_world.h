// CellWorld: the world of a cell as the server sees it, wherever it lives: what it looks like, where everything is, and
// what a person does in it. LocalWorld is one in this process, RemoteWorldProxy one in a process of its own.
//
// Threads: any, but execute(): the cell's group.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "core/value/expected.h"
#include "core/value/value.h"
#include "server/cell/person_command.h"
#include "services/mutex.h"

namespace race::server {

class CellWorld {
 public:
  /// Called once, on any thread: schemas/person.json (frozen) after the command, or why the command was refused.
  using Done = std::function<void(Expected<Value> person)>;

  /// Called once, on any thread, right before the command executes. If it returns false, the command is dropped and
  /// Done is not called.
  using Wanted = std::function<bool()>;

  virtual ~CellWorld() = default;

  /// schemas/scene.json, frozen. Error `unavailable`: the world is not there.
  virtual Expected<Value> scene() const = 0;
  /// The text of a URDF file that the scene names. Errors: `not_found`; that of scene().
  virtual Expected<std::string> file(const std::string& name) const = 0;
  /// False if there is certainly no such link or part.
  virtual bool may_have(const std::string& body) const = 0;

  /// Executes the command; without one, reports only what hands hold. Errors: those of perform(); that of scene().
  virtual void execute(const std::optional<PersonCommand>& command, Wanted wanted, Done done) = 0;

  /// `publish` gets poses (schemas/cell_pose.json, frozen) at 30 Hz of world time while they are watched. To be set
  /// before the first step.
  void on_pose(std::function<void(Value)> publish) { publish_pose_ = std::move(publish); }
  void watch_pose(bool on) { want_pose(kWatched, on); }
  bool is_pose_watched() const {
    const services::MutexLock lock(mutex_);
    return wanted_[kWatched];
  }
  /// The same for those who record poses: they are published while somebody watches or records.
  void record_pose(bool on) { want_pose(kRecorded, on); }

 protected:
  virtual void set_pose_wanted(bool on) = 0;
  std::function<void(Value)> publish_pose_ = [](const Value&) {};

 private:
  enum Purpose : std::uint8_t { kWatched, kRecorded };
  void want_pose(Purpose purpose, bool on) {
    const services::MutexLock lock(mutex_);
    wanted_.at(purpose) = on;
    set_pose_wanted(wanted_[kWatched] || wanted_[kRecorded]);
  }

  mutable services::Mutex mutex_;
  std::array<bool, 2> wanted_ GUARDED_BY(mutex_) = {};
};

}  // namespace race::server
