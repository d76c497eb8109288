#include "server/cell/outside_world.h"

#include "server/cell/world_check.h"

namespace race::server {
namespace {

Expected<remote::RemoteWorld::Rules> let_in(const Value& world) {
  ASSIGN_OR_RETURN(WorldNames found, check_world(world));
  const auto names = std::make_shared<const WorldNames>(std::move(found));  // held by both rules
  return remote::RemoteWorld::Rules{[names](const Value& pose) { return check_pose(*names, pose); },
                                    [names](const Value& person) { return check_person(*names, person); }};
}

}  // namespace

OutsideWorld::OutsideWorld(const services::Clock& clock)
    : end_(clock, let_in, [this](Value pose) { publish_pose_(std::move(pose)); }) {}

Expected<Value> OutsideWorld::brought(std::string_view what) const {
  const Value world = end_.world();
  if (world.is_null()) return remote::no_world();
  return *world.find(what);
}

Expected<Value> OutsideWorld::scene() const { return brought("scene"); }

Expected<std::string> OutsideWorld::file(const std::string& name) const {
  ASSIGN_OR_RETURN(const Value files, brought("files"));
  const Value* text = files.find(name);
  if (!text) return unexpected(ErrorCode::not_found, "the scene names no such file", name);
  return text->as_string();
}

void OutsideWorld::act(const std::optional<PersonAct>& act, Wanted wanted, Done done) {
  end_.execute(act ? write_person_act(*act) : Value(), std::move(wanted), std::move(done));
}

}  // namespace race::server
