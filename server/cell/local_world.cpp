#include "server/cell/local_world.h"

#include <filesystem>

#include "server/cell/scene_json.h"
#include "server/store/files.h"

namespace race::server {

Expected<std::unique_ptr<LocalWorld>> LocalWorld::load(const std::string& scene_path) {
  ASSIGN_OR_RETURN(auto world, world::World::load(scene_path));
  ASSIGN_OR_RETURN(std::string urdf, read_file(world->scene().robot.urdf));
  return std::unique_ptr<LocalWorld>(new LocalWorld(std::move(world), std::move(urdf)));
}

LocalWorld::LocalWorld(std::unique_ptr<world::World> world, std::string urdf)
    : world_(std::move(world)),
      person_(*world_),
      scene_(scene_json(*world_)),
      urdf_name_(std::filesystem::path(world_->scene().robot.urdf).filename()),
      urdf_(std::move(urdf)) {}

Value LocalWorld::description() const { return Dict{{"scene", scene_}, {"files", Dict{{urdf_name_, urdf_}}}}; }

Value LocalWorld::pose(services::Time now) const {
  Value pose = pose_json(*world_, person_, now);
  return std::move(pose.freeze());
}

Expected<std::string> LocalWorld::file(const std::string& name) const {
  if (name != urdf_name_) return unexpected(ErrorCode::not_found, "the scene names no such file", name);
  return urdf_;
}

Expected<Value> LocalWorld::perform(const std::optional<PersonCommand>& command) {
  if (command)
    if (auto done = server::perform(*command, person_); !done) return tl::unexpected(std::move(done).error());
  Value person = person_json(*world_, person_);
  return std::move(person.freeze());
}

void LocalWorld::reset() {
  world_->reset();
  person_.let_go();
}

void LocalWorld::step() {
  person_.step();
  world_->step();
}

void LocalWorld::publish_pose(services::Time now) const {
  constexpr std::int64_t kStepsPerPose = 33;
  if (watched_ && world_->steps() % kStepsPerPose == 0) publish_pose_(pose(now));
}

}  // namespace race::server
