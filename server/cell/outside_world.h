// OutsideWorld: a world in a process of its own, as that process shows it. While there is none, everything is
// `unavailable`; what comes back is a new world, with nobody's hands in it.
//
// Threads: any; poses are published on the group's of the process.
#pragma once

#include "server/cell/cell_world.h"
#include "services/remote/remote_world.h"

namespace race::server {

class OutsideWorld final : public CellWorld {
 public:
  /// The clock outlives it.
  explicit OutsideWorld(const services::Clock& clock);

  /// The end that the process talks to.
  remote::RemoteWorld& end() { return end_; }

  Expected<Value> scene() const override;
  Expected<std::string> file(const std::string& name) const override;
  /// The process knows, and refuses the act.
  bool may_have(const std::string&) const override { return true; }
  void act(const std::optional<PersonAct>& act, Wanted wanted, Done done) override;
  void watch_pose(bool on) override { end_.watch(on); }

 private:
  Expected<Value> brought(std::string_view what) const;

  remote::RemoteWorld end_;
};

}  // namespace race::server
