#include "server/cell/inside_world.h"

#include <filesystem>

#include "server/cell/scene_json.h"
#include "server/store/read_file.h"

namespace race::server {

Expected<std::unique_ptr<InsideWorld>> InsideWorld::load(const std::string& scene_path) {
  ASSIGN_OR_RETURN(auto world, world::World::load(scene_path));
  ASSIGN_OR_RETURN(std::string urdf, read_file(world->scene().robot.urdf));
  return std::unique_ptr<InsideWorld>(new InsideWorld(std::move(world), std::move(urdf)));
}

InsideWorld::InsideWorld(std::unique_ptr<world::World> world, std::string urdf)
    : world_(std::move(world)),
      person_(*world_),
      scene_(scene_json(*world_)),
      urdf_name_(std::filesystem::path(world_->scene().robot.urdf).filename()),
      urdf_(std::move(urdf)) {}

Value InsideWorld::whole() const { return Dict{{"scene", scene_}, {"files", Dict{{urdf_name_, urdf_}}}}; }

Value InsideWorld::pose(services::Time now) const {
  Value pose = pose_json(*world_, person_, now);
  return std::move(pose.freeze());
}

Expected<std::string> InsideWorld::file(const std::string& name) const {
  if (name != urdf_name_) return unexpected(ErrorCode::not_found, "the scene names no such file", name);
  return urdf_;
}

Expected<Value> InsideWorld::perform(const std::optional<PersonAct>& act) {
  if (act)
    if (auto done = server::perform(*act, person_); !done) return tl::unexpected(std::move(done).error());
  Value person = person_json(*world_, person_);
  return std::move(person.freeze());
}

void InsideWorld::step() {
  person_.step();
  world_->step();
}

void InsideWorld::show(services::Time now) const {
  constexpr std::int64_t kStepsPerPose = 33;
  if (watched_ && world_->steps() % kStepsPerPose == 0) publish_pose_(pose(now));
}

}  // namespace race::server
