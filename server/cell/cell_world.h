// CellWorld: the world of a cell as the server sees it, wherever it lives: what it looks like, where everything is, and
// what a person does in it. InsideWorld is one in this process, OutsideWorld one in a process of its own.
//
// Threads: any, but act(): the cell's group.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "core/value/expected.h"
#include "core/value/value.h"
#include "server/cell/person_act.h"

namespace race::server {

class CellWorld {
 public:
  /// Called once, on any thread: schemas/person.json (frozen) as it is after the act, or why the act was refused.
  using Done = std::function<void(Expected<Value> person)>;

  /// Asked once, on any thread, right before the act is done: after a no it is not done, and nobody told.
  using Wanted = std::function<bool()>;

  virtual ~CellWorld() = default;

  /// schemas/scene.json, frozen. Error `unavailable`: the world is not there.
  virtual Expected<Value> scene() const = 0;
  /// The text of a URDF file that the scene names. Errors: `not_found`; that of scene().
  virtual Expected<std::string> file(const std::string& name) const = 0;
  /// Whether there may be such a link or part; false: there is none for sure.
  virtual bool may_have(const std::string& body) const = 0;

  /// Does the act; without one, only tells what hands hold. Errors: those of perform(); that of scene().
  virtual void act(const std::optional<PersonAct>& act, Wanted wanted, Done done) = 0;

  /// `publish` gets poses (schemas/cell_pose.json, frozen) at 30 Hz of world time while they are watched. To be set
  /// before the first step.
  void on_pose(std::function<void(Value)> publish) { publish_pose_ = std::move(publish); }
  virtual void watch_pose(bool on) = 0;

 protected:
  std::function<void(Value)> publish_pose_ = [](const Value&) {};
};

}  // namespace race::server
