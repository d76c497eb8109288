// RemoteWorldProxy: a world in another process, as that process reports it. While the process is not connected,
// everything is `unavailable`; a process that reconnects has a new world without hands.
//
// Threads: any; poses are published on the group's thread.
#pragma once

#include "server/cell/cell_world.h"
#include "services/remote/remote_world.h"

namespace race::server {

class RemoteWorldProxy final : public CellWorld {
 public:
  /// The clock outlives it.
  explicit RemoteWorldProxy(const services::Clock& clock);

  /// The endpoint that the process talks to.
  remote::RemoteWorld& end() { return end_; }

  Expected<Value> scene() const override;
  Expected<std::string> file(const std::string& name) const override;
  /// Unknown here; the process refuses the command.
  bool may_have(const std::string&) const override { return true; }
  void execute(const std::optional<PersonCommand>& command, Wanted wanted, Done done) override;

 private:
  void set_pose_wanted(bool on) override { end_.watch(on); }
  Expected<Value> member(std::string_view what) const;

  remote::RemoteWorld end_;
};

}  // namespace race::server
