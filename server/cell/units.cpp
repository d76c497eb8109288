#include "server/cell/units.h"

#include <array>
#include <filesystem>
#include <limits>

#include "core/value/json.h"
#include "server/cell/inside_world.h"
#include "server/store/read_file.h"
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

// What the server says that somebody does; it has read the act before.
Expected<Value> act_in(InsideWorld& world, const Value& json) {
  if (json.is_null()) return world.perform(std::nullopt);
  const auto act = read_person_act(json, std::numeric_limits<double>::infinity());
  if (!act) return tl::unexpected(act.error().front());
  return world.perform(*act);
}

Expected<void> make_cell(const UnitSetup& setup, remote::RemoteUnit& unit) {
  ASSIGN_OR_RETURN(std::shared_ptr<InsideWorld> inside, InsideWorld::load(fs::path(setup.folder) / "scene.json"));
  world::World& world = inside->world();
  ASSIGN_OR_RETURN(auto robot, robot::Robot::create(unit.declare("robot", "robot"), world));
  unit.attach("robot", std::move(robot));
  unit.attach("gripper", std::make_unique<gripper::Gripper>(unit.declare("gripper", "gripper"), world));
  if (world.scene().camera)
    unit.attach("camera", std::make_unique<camera::Camera>(unit.declare("camera", "KinectDriver"), world, 0));
  inside->on_pose([&unit](Value pose) { unit.show(std::move(pose)); });
  unit.bring({inside->whole(), [inside](const Value& act) { return act_in(*inside, act); },
              [inside](bool on) { inside->watch_pose(on); }});
  unit.before_step([inside] { inside->step(); });
  unit.after_step([inside, &unit] { inside->show(unit.clock().now()); });
  return {};
}

Expected<void> make_recognition(const UnitSetup& setup, remote::RemoteUnit& unit) {
  ASSIGN_OR_RETURN(auto parts, recognition::load_parts(fs::path(setup.folder) / "parts.json"));
  services::ServiceHost& host = unit.declare("obj_rec", "ObjectRecognition");
  unit.attach("obj_rec", std::make_unique<recognition::ObjectRecognition>(host, std::move(parts)));
  return {};
}

Expected<void> make_database(const UnitSetup& setup, remote::RemoteUnit& unit) {
  ASSIGN_OR_RETURN(auto store, open_store(setup.folder, setup.database));
  unit.attach("db", std::make_unique<database::Database>(std::move(store), unit.declare("db", "database")));
  return {};
}

// How a component asks its desk in the server.
display::ServerRequest asking(remote::RemoteUnit& unit, const char* key) {
  return [&unit, key](std::string_view function, Dict arguments) {
    return unit.request(key, function, std::move(arguments));
  };
}

Expected<void> make_display(const UnitSetup& setup, remote::RemoteUnit& unit) {
  services::ServiceHost& host = unit.declare("display", "display");
  auto backend = std::make_shared<display::RemoteDisplayBackend>(asking(unit, "display"));
  unit.attach("display", std::make_unique<display::Display>(*backend, setup.folder, host));
  unit.on_news("display", [backend] { backend->invalidate(); });
  return {};
}

Expected<void> make_audio(const UnitSetup&, remote::RemoteUnit& unit) {
  services::ServiceHost& host = unit.declare("audio", "audio");
  auto speakers = std::make_shared<audio::RemoteSpeakers>(asking(unit, "audio"));
  unit.attach("audio", std::make_unique<audio::Audio>(*speakers, host));
  unit.on_news("audio", [speakers] { speakers->invalidate(); });
  return {};
}

}  // namespace

std::span<const Unit> units() {
  static const std::array kUnits = {
      Unit{"cell",
           {{"robot", "robot", &robot::model()},
            {"gripper", "gripper", &gripper::model()},
            {"camera", "KinectDriver", &camera::model()}},
           true,
           make_cell},
      Unit{"recognition", {{"obj_rec", "ObjectRecognition", &recognition::model()}}, false, make_recognition},
      Unit{"database", {{"db", "database", &database::model()}}, false, make_database},
      Unit{"display", {{"display", "display", &display::model()}}, false, make_display},
      Unit{"audio", {{"audio", "audio", &audio::model()}}, false, make_audio},
  };
  return kUnits;
}

std::string unit_names() {
  std::string names;
  for (const Unit& unit : units()) names += (names.empty() ? "" : ", ") + std::string(unit.name);
  return names;
}

Expected<const Unit*> find_unit(std::string_view name) {
  for (const Unit& unit : units())
    if (unit.name == name) return &unit;
  return unexpected(ErrorCode::not_found, "there is no such unit; there are " + unit_names(), std::string(name));
}

Expected<database::Store> open_store(const std::string& folder, const std::string& database) {
  ASSIGN_OR_RETURN(auto store, database::Store::open(database));
  const fs::path seeds = fs::path(folder) / "database.json";
  if (folder.empty() || !fs::exists(seeds)) return store;
  ASSIGN_OR_RETURN(const std::string text, read_file(seeds));
  ASSIGN_OR_RETURN(const Value values, parse_json(text));
  if (!values.is_dict()) return unexpected(ErrorCode::type, "expected an object of key: value", seeds);
  for (const auto& [key, value] : values.as_dict()) {
    if (store.get(key.as_string())) continue;
    if (auto put = store.put(key.as_string(), value); !put) return tl::unexpected(std::move(put).error());
  }
  return store;
}

}  // namespace race::server
