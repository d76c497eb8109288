#include "server/cell/outside_world.h"

#include "server/cell/world_check.h"

namespace race::server {

OutsideWorld::OutsideWorld(const services::Clock& clock)
    : end_(clock, {check_world, check_pose, check_person}, [this](Value pose) { publish_pose_(std::move(pose)); }) {}

Expected<Value> OutsideWorld::brought(std::string_view what) const {
  const Value world = end_.world();
  if (world.is_null()) return unexpected(ErrorCode::unavailable, "the process of the cell is not there");
  return *world.find(what);
}

Expected<Value> OutsideWorld::scene() const { return brought("scene"); }

Expected<std::string> OutsideWorld::file(const std::string& name) const {
  ASSIGN_OR_RETURN(const Value files, brought("files"));
  const Value* text = files.find(name);
  if (!text) return unexpected(ErrorCode::not_found, "the scene names no such file", name);
  return text->as_string();
}

void OutsideWorld::act(const std::optional<PersonAct>& act, Done done) {
  end_.act(act ? write_person_act(*act) : Value(), std::move(done));
}

}  // namespace race::server
