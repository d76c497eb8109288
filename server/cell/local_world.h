// LocalWorld: a world in this process, with the person at it. Either the server's cell or the process of the
// group `cell` has one.
//
// Threads: the group's, execute() too; the other functions of CellWorld are for any.
#pragma once

#include <atomic>
#include <memory>
#include <string>

#include "server/cell/cell_world.h"
#include "services/clock.h"
#include "services/world/person.h"
#include "services/world/world.h"

namespace race::server {

class LocalWorld final : public CellWorld {
 public:
  /// Reads the scene file and its URDF. Errors: `io`, and those of the files.
  static Expected<std::unique_ptr<LocalWorld>> load(const std::string& scene_path);

  /// What robot, gripper and camera act in.
  world::World& world() { return *world_; }
  /// What the process of the group `cell` sends to the server (world_check.h).
  Value description() const;
  /// schemas/cell_pose.json, frozen.
  Value pose(services::Time now) const;

  Expected<Value> scene() const override { return scene_; }
  Expected<std::string> file(const std::string& name) const override;
  bool may_have(const std::string& body) const override { return world_->has(body); }
  /// As execute(), at once.
  Expected<Value> perform(const std::optional<PersonCommand>& command);
  void execute(const std::optional<PersonCommand>& command, Wanted wanted, Done done) override {
    if (wanted()) done(perform(command));
  }

  /// World::reset(); hands let go.
  void reset();

  /// World time goes on by 1 ms.
  void step();
  /// Publishes the pose if it is watched and one is due in this step.
  void publish_pose(services::Time now) const;

 private:
  void set_pose_wanted(bool on) override { watched_ = on; }
  LocalWorld(std::unique_ptr<world::World> world, std::string urdf);

  const std::unique_ptr<world::World> world_;
  world::Person person_;
  const Value scene_;
  const std::string urdf_name_, urdf_;
  std::atomic<bool> watched_{false};
};

}  // namespace race::server
