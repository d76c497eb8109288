#include "server/cell/component_groups.h"

#include <array>
#include <filesystem>
#include <limits>

#include "core/value/json.h"
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

namespace fs = std::filesystem;

// Executes a command that the server sends; the server has validated it before.
Expected<Value> execute_in(LocalWorld& world, const Value& json) {
  if (json.is_null()) return world.perform(std::nullopt);
  const auto command = read_person_command(json, std::numeric_limits<double>::infinity());
  if (!command) return tl::unexpected(command.error().front());
  return world.perform(*command);
}

Expected<void> make_cell(const GroupSetup& setup, remote::ProcessHost& process) {
  ASSIGN_OR_RETURN(std::shared_ptr<LocalWorld> local_world, LocalWorld::load(fs::path(setup.folder) / "scene.json"));
  world::World& world = local_world->world();
  ASSIGN_OR_RETURN(auto robot, robot::Robot::create(process.declare("robot", "robot"), world));
  process.attach("robot", std::move(robot));
  process.attach("gripper", std::make_unique<gripper::Gripper>(process.declare("gripper", "gripper"), world));
  if (world.scene().camera)
    process.attach("camera", std::make_unique<camera::Camera>(process.declare("camera", "KinectDriver"), world, 0));
  local_world->on_pose([&process](Value pose) { process.send_pose(std::move(pose)); });
  process.set_world({local_world->description(),
                     [local_world](const Value& command) { return execute_in(*local_world, command); },
                     [local_world](bool on) { local_world->watch_pose(on); }});
  process.before_step([local_world] { local_world->step(); });
  process.after_step([local_world, &process] { local_world->publish_pose(process.clock().now()); });
  return {};
}

Expected<void> make_recognition(const GroupSetup& setup, remote::ProcessHost& process) {
  ASSIGN_OR_RETURN(auto parts, recognition::load_parts(fs::path(setup.folder) / "parts.json"));
  services::ServiceHost& host = process.declare("obj_rec", "ObjectRecognition");
  process.attach("obj_rec", std::make_unique<recognition::ObjectRecognition>(host, std::move(parts)));
  return {};
}

Expected<void> make_database(const GroupSetup& setup, remote::ProcessHost& process) {
  ASSIGN_OR_RETURN(auto store, open_store(setup.folder, setup.database));
  process.attach("db", std::make_unique<database::Database>(std::move(store), process.declare("db", "database")));
  return {};
}

// How a component calls its host functions in the server.
display::ServerRequest asking(remote::ProcessHost& process, const char* key) {
  return [&process, key](std::string_view function, Dict arguments) {
    return process.request(key, function, std::move(arguments));
  };
}

Expected<void> make_display(const GroupSetup& setup, remote::ProcessHost& process) {
  services::ServiceHost& host = process.declare("display", "display");
  auto backend = std::make_shared<display::RemoteDisplayBackend>(asking(process, "display"));
  process.attach("display", std::make_unique<display::Display>(*backend, setup.folder, host));
  process.on_host_change("display", [backend] { backend->invalidate(); });
  return {};
}

Expected<void> make_audio(const GroupSetup&, remote::ProcessHost& process) {
  services::ServiceHost& host = process.declare("audio", "audio");
  auto speakers = std::make_shared<audio::RemoteSpeakers>(asking(process, "audio"));
  process.attach("audio", std::make_unique<audio::Audio>(*speakers, host));
  process.on_host_change("audio", [speakers] { speakers->invalidate(); });
  return {};
}

}  // namespace

std::span<const ComponentGroup> component_groups() {
  static const std::array kGroups = {
      ComponentGroup{"cell",
                     {{"robot", "robot", &robot::model()},
                      {"gripper", "gripper", &gripper::model()},
                      {"camera", "KinectDriver", &camera::model()}},
                     true,
                     make_cell},
      ComponentGroup{"recognition", {{"obj_rec", "ObjectRecognition", &recognition::model()}}, false, make_recognition},
      ComponentGroup{"database", {{"db", "database", &database::model()}}, false, make_database},
      ComponentGroup{"display", {{"display", "display", &display::model()}}, false, make_display},
      ComponentGroup{"audio", {{"audio", "audio", &audio::model()}}, false, make_audio},
  };
  return kGroups;
}

std::string component_group_names() {
  std::string names;
  for (const ComponentGroup& group : component_groups()) names += (names.empty() ? "" : ", ") + std::string(group.name);
  return names;
}

std::vector<std::string> names_of_component_groups() {
  std::vector<std::string> names;
  for (const ComponentGroup& group : component_groups()) names.emplace_back(group.name);
  return names;
}

Expected<const ComponentGroup*> find_component_group(std::string_view name) {
  for (const ComponentGroup& group : component_groups())
    if (group.name == name) return &group;
  return unexpected(ErrorCode::not_found, "there is no such component group; there are " + component_group_names(),
                    std::string(name));
}

Expected<Dict> start_values(const std::string& folder) {
  if (folder.empty()) return Dict{};
  const fs::path file = fs::path(folder) / "database.json";
  ASSIGN_OR_RETURN(const bool is_there, file_exists(file));
  if (!is_there) return Dict{};
  ASSIGN_OR_RETURN(const std::string text, read_file(file));
  ASSIGN_OR_RETURN(Value values, parse_json(text));
  if (!values.is_dict()) return unexpected(ErrorCode::type, "expected an object of key: value", file);
  values.freeze();
  return values.as_dict();
}

Expected<database::Store> open_store(const std::string& folder, const std::string& database) {
  ASSIGN_OR_RETURN(auto store, database::Store::open(database));
  ASSIGN_OR_RETURN(const Dict values, start_values(folder));
  for (const auto& [key, value] : values) {
    if (store.get(key.as_string())) continue;
    if (auto put = store.put(key.as_string(), value); !put) return tl::unexpected(std::move(put).error());
  }
  return store;
}

}  // namespace race::server
