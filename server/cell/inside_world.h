// InsideWorld: a world in this process, with whoever stands at it. The cell of a server has one, or the process that is
// its cell.
//
// Threads: the group's, act() too; the other functions of CellWorld are for any.
#pragma once

#include <atomic>
#include <memory>
#include <string>

#include "server/cell/cell_world.h"
#include "services/clock.h"
#include "services/world/person.h"
#include "services/world/world.h"

namespace race::server {

class InsideWorld final : public CellWorld {
 public:
  /// Reads the scene file and its URDF. Errors: `io`, and those of the files.
  static Expected<std::unique_ptr<InsideWorld>> load(const std::string& scene_path);

  /// What robot, gripper and camera act in.
  world::World& world() { return *world_; }
  /// What a process that is a cell brings (world_check.h).
  Value whole() const;
  /// schemas/cell_pose.json, frozen.
  Value pose(services::Time now) const;

  Expected<Value> scene() const override { return scene_; }
  Expected<std::string> file(const std::string& name) const override;
  bool may_have(const std::string& body) const override { return world_->has(body); }
  /// As act(), at once.
  Expected<Value> perform(const std::optional<PersonAct>& act);
  void act(const std::optional<PersonAct>& act, Wanted wanted, Done done) override {
    if (wanted()) done(perform(act));
  }
  void watch_pose(bool on) override { watched_ = on; }

  /// World time goes on by 1 ms.
  void step();
  /// Publishes the pose if it is watched and one is due in this step.
  void show(services::Time now) const;

 private:
  InsideWorld(std::unique_ptr<world::World> world, std::string urdf);

  const std::unique_ptr<world::World> world_;
  world::Person person_;
  const Value scene_;
  const std::string urdf_name_, urdf_;
  std::atomic<bool> watched_{false};
};

}  // namespace race::server
