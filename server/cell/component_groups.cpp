#include "server/cell/component_groups.h"

#include <algorithm>
#include <array>
#include <limits>

#include "core/value/json.h"
#include "server/accounts/role.h"
#include "server/cell/local_world.h"
#include "server/store/files.h"
#include "services/audio/audio.h"
#include "services/audio/remote_speakers.h"
#include "services/camera/camera.h"
#include "services/database/database.h"
#include "services/display/display.h"
#include "services/display/remote_display_backend.h"
#include "services/gripper/gripper.h"
#include "services/recognition/object_recognition.h"
#include "services/robot/robot.h"

namespace race::server {
namespace {

// Executes a command that the server sends; the server has validated it before.
Expected<Value> execute_in(LocalWorld& world, const Value& json) {
  if (json.is_null()) return world.perform(std::nullopt);
  const auto command = read_person_command(json, std::numeric_limits<double>::infinity());
  if (!command) return tl::unexpected(command.error().front());
  return world.perform(*command);
}

Expected<void> check_file(const std::string& file, const char* what) {
  if (!file.empty()) return {};
  return unexpected(ErrorCode::missing, "needs the folder of a cell that has " + std::string(what), "--folder");
}

// Makes a component of this type, if the cell has the service.
template <typename Make>
Expected<void> add(std::string_view type, const GroupSetup& setup, remote::ProcessHost& process, Make make) {
  const std::optional<std::string> key = setup.cell.key_of(type);
  if (!key) return {};
  ASSIGN_OR_RETURN(std::unique_ptr<services::Component> component,
                   make(process.declare(*key, std::string(type)), *key));
  process.attach(*key, std::move(component));
  return {};
}

using MadeComponent = Expected<std::unique_ptr<services::Component>>;

Expected<void> make_cell(const GroupSetup& setup, remote::ProcessHost& process) {
  if (auto there = check_file(setup.cell.scene, "a scene"); !there) return there;
  ASSIGN_OR_RETURN(std::shared_ptr<LocalWorld> local_world, LocalWorld::load(setup.cell.scene));
  world::World& world = local_world->world();
  auto added = add(kRobotType, setup, process, [&](services::ServiceHost& host, const std::string&) -> MadeComponent {
    return robot::Robot::create(host, world);
  });
  if (!added) return added;
  added = add(kGripperType, setup, process, [&](services::ServiceHost& host, const std::string&) -> MadeComponent {
    return std::make_unique<gripper::Gripper>(host, world);
  });
  if (!added) return added;
  if (world.scene().camera)
    added = add(kCameraType, setup, process, [&](services::ServiceHost& host, const std::string&) -> MadeComponent {
      return std::make_unique<camera::Camera>(host, world, 0);
    });
  if (!added) return added;
  local_world->on_pose([&process](Value pose) { process.send_pose(std::move(pose)); });
  process.set_world({local_world->description(),
                     [local_world](const Value& command) { return execute_in(*local_world, command); },
                     [local_world](bool on) { local_world->watch_pose(on); }});
  process.before_step([local_world] { local_world->step(); });
  process.after_step([local_world, &process] { local_world->publish_pose(process.clock().now()); });
  return {};
}

Expected<void> make_recognition(const GroupSetup& setup, remote::ProcessHost& process) {
  if (auto there = check_file(setup.cell.parts, "parts"); !there) return there;
  ASSIGN_OR_RETURN(auto parts, recognition::load_parts(setup.cell.parts));
  return add(kRecognitionType, setup, process, [&](services::ServiceHost& host, const std::string&) -> MadeComponent {
    return std::make_unique<recognition::ObjectRecognition>(host, std::move(parts));
  });
}

Expected<void> make_database(const GroupSetup& setup, remote::ProcessHost& process) {
  ASSIGN_OR_RETURN(auto store, open_store(setup.cell, setup.database));
  return add(kDatabaseType, setup, process, [&](services::ServiceHost& host, const std::string&) -> MadeComponent {
    return std::make_unique<database::Database>(std::move(store), host);
  });
}

// How a component calls its host functions in the server.
display::ServerRequest asking(remote::ProcessHost& process, const std::string& key) {
  return [&process, key](std::string_view function, Dict arguments) {
    return process.request(key, function, std::move(arguments));
  };
}

Expected<void> make_display(const GroupSetup& setup, remote::ProcessHost& process) {
  std::shared_ptr<display::RemoteDisplayBackend> backend;
  const auto make = [&](services::ServiceHost& host, const std::string& key) -> MadeComponent {
    backend = std::make_shared<display::RemoteDisplayBackend>(asking(process, key));
    return std::make_unique<display::Display>(*backend, setup.folder, host);
  };
  if (auto added = add(kDisplayType, setup, process, make); !added || !backend) return added;
  process.on_host_change(*setup.cell.key_of(kDisplayType), [backend] { backend->invalidate(); });
  return {};
}

Expected<void> make_audio(const GroupSetup& setup, remote::ProcessHost& process) {
  std::shared_ptr<audio::RemoteSpeakers> speakers;
  const auto make = [&](services::ServiceHost& host, const std::string& key) -> MadeComponent {
    speakers = std::make_shared<audio::RemoteSpeakers>(asking(process, key));
    return std::make_unique<audio::Audio>(*speakers, host);
  };
  if (auto added = add(kAudioType, setup, process, make); !added || !speakers) return added;
  process.on_host_change(*setup.cell.key_of(kAudioType), [speakers] { speakers->invalidate(); });
  return {};
}

}  // namespace

std::span<const ComponentGroup> component_groups() {
  static const std::array kGroups = {
      ComponentGroup{
          "cell",
          {{kRobotType, &robot::model()}, {kGripperType, &gripper::model()}, {kCameraType, &camera::model()}},
          true,
          make_cell},
      ComponentGroup{"recognition", {{kRecognitionType, &recognition::model()}}, false, make_recognition},
      ComponentGroup{"database", {{kDatabaseType, &database::model()}}, false, make_database},
      ComponentGroup{"display", {{kDisplayType, &display::model()}}, false, make_display},
      ComponentGroup{"audio", {{kAudioType, &audio::model()}}, false, make_audio},
  };
  return kGroups;
}

std::string component_group_names() {
  std::string names;
  for (const ComponentGroup& group : component_groups()) names += (names.empty() ? "" : ", ") + std::string(group.name);
  return names;
}

std::vector<std::string> groups_of_processes() {
  std::vector<std::string> names;
  for (const ComponentGroup& group : component_groups()) names.emplace_back(group.name);
  names.emplace_back(remote::kOwnGroup);
  return names;
}

Expected<const ComponentGroup*> find_component_group(std::string_view name) {
  for (const ComponentGroup& group : component_groups())
    if (group.name == name) return &group;
  return unexpected(ErrorCode::not_found, "there is no such component group; there are " + component_group_names(),
                    std::string(name));
}

Expected<void> check_account_group(std::string_view name) {
  const std::vector<std::string> groups = groups_of_processes();
  if (name == kLocal || std::ranges::find(groups, name) != groups.end()) return {};
  return unexpected(ErrorCode::not_found,
                    "there is no such component group; there are " + component_group_names() + ", and " +
                        std::string(remote::kOwnGroup) + " for services of one's own",
                    std::string(name));
}

std::vector<remote::RemoteService> services_of(const ComponentGroup& group, const CellFile& cell) {
  std::vector<remote::RemoteService> services;
  for (const auto& [type, model] : group.services)
    if (const auto key = cell.key_of(type)) services.push_back({*key, std::string(type), model});
  return services;
}

Expected<Dict> start_values(const CellFile& cell) {
  ASSIGN_OR_RETURN(const bool is_there, cell.has(cell.database));
  if (!is_there) return Dict{};
  ASSIGN_OR_RETURN(const std::string text, read_file(cell.database));
  ASSIGN_OR_RETURN(Value values, parse_json(text));
  if (!values.is_dict()) return unexpected(ErrorCode::type, "expected an object of key: value", cell.database);
  values.freeze();
  return values.as_dict();
}

Expected<database::Store> open_store(const CellFile& cell, const std::string& database) {
  ASSIGN_OR_RETURN(auto store, database::Store::open(database));
  ASSIGN_OR_RETURN(const Dict values, start_values(cell));
  for (const auto& [key, value] : values) {
    if (store.get(key.as_string())) continue;
    if (auto put = store.put(key.as_string(), value); !put) return tl::unexpected(std::move(put).error());
  }
  return store;
}

}  // namespace race::server
