#include "server/cell/remote_world_proxy.h"

#include "server/cell/world_check.h"

namespace race::server {
namespace {

Expected<remote::RemoteWorld::Rules> make_rules(const Value& world) {
  ASSIGN_OR_RETURN(WorldNames found, check_world(world));
  const auto names = std::make_shared<const WorldNames>(std::move(found));  // held by both rules
  return remote::RemoteWorld::Rules{[names](const Value& pose) { return check_pose(*names, pose); },
                                    [names](const Value& person) { return check_person(*names, person); }};
}

}  // namespace

RemoteWorldProxy::RemoteWorldProxy(const services::Clock& clock)
    : end_(clock, make_rules, [this](Value pose) { publish_pose_(std::move(pose)); }) {}

Expected<Value> RemoteWorldProxy::member(std::string_view what) const {
  const Value world = end_.world();
  if (world.is_null()) return remote::no_world();
  return *world.find(what);
}

Expected<Value> RemoteWorldProxy::scene() const { return member("scene"); }

Expected<std::string> RemoteWorldProxy::file(const std::string& name) const {
  ASSIGN_OR_RETURN(const Value files, member("files"));
  const Value* text = files.find(name);
  if (!text) return unexpected(ErrorCode::not_found, "the scene names no such file", name);
  return text->as_string();
}

void RemoteWorldProxy::execute(const std::optional<PersonCommand>& command, Wanted wanted, Done done) {
  end_.execute(command ? write_person_command(*command) : Value(), std::move(wanted), std::move(done));
}

}  // namespace race::server
