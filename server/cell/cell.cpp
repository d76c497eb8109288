#include "server/cell/cell.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <utility>

#include "server/cell/component_groups.h"
#include "server/cell/remote_world_proxy.h"
#include "server/store/files.h"
#include "services/camera/camera.h"
#include "services/database/database.h"
#include "services/failures.h"
#include "services/gripper/gripper.h"
#include "services/recognition/object_recognition.h"
#include "services/robot/robot.h"
#include "services/thread_name.h"
#include "services/time_slice.h"
#include "services/timer/timer.h"

namespace race::server {

namespace fs = std::filesystem;

Expected<std::unique_ptr<Cell>> Cell::create(const CellSetup& setup, services::HostObserver& observer) {
  std::unique_ptr<Cell> cell(new Cell(observer, setup.gate));
  cell->waits_ = !setup.own_threads;
  const fs::path scene = fs::path(setup.folder) / "scene.json";
  const auto here = [&](const char* group) { return std::ranges::find(setup.remote, group) == setup.remote.end(); };
  if (auto added = cell->add_remotes(setup); !added) return tl::unexpected(std::move(added).error());
  bool has_world = here("cell") && !setup.folder.empty();
  if (has_world) {
    ASSIGN_OR_RETURN(has_world, file_exists(scene));
  }
  if (has_world) {
    if (auto added = cell->add_world(scene, setup.seed); !added) return tl::unexpected(std::move(added).error());
    if (auto added = cell->add_vision(setup); !added) return tl::unexpected(std::move(added).error());
  }
  if (here("database"))
    if (auto added = cell->add_database(setup); !added) return tl::unexpected(std::move(added).error());
  auto& host = cell->host_.declare("timer", "timer", cell->queue_);
  cell->host_.attach("timer", std::make_unique<timer::Timer>(host));
  for (const ExtraService& service : setup.extra_services) {
    if (cell->host_.service(service.key)) continue;  // its process brings it
    cell->host_.attach(service.key, service.make(cell->host_.declare(service.key, service.type, cell->queue_)));
  }
  return cell;
}

Expected<void> Cell::add_remotes(const CellSetup& setup) {
  remotes_ = std::make_unique<remote::Remotes>(host_, clock_, setup.heartbeat);
  for (const std::string& name : setup.remote) {
    ASSIGN_OR_RETURN(const ComponentGroup* group, find_component_group(name));
    std::vector<remote::RemoteService> services = group->services;
    for (remote::RemoteService& service : services)
      for (const ExtraService& extra : setup.extra_services)
        if (extra.key == service.key) service.host_functions = extra.host_functions;
    remote::RemoteWorld* world = nullptr;
    if (group->world) {
      auto proxy = std::make_unique<RemoteWorldProxy>(clock_);
      world = &proxy->end();
      world_ = std::move(proxy);
    }
    remotes_->add(name, services, world);
  }
  return {};
}

Expected<void> Cell::add_world(const std::string& scene_path, std::uint64_t seed) {
  ASSIGN_OR_RETURN(auto local_world, LocalWorld::load(scene_path));
  local_world_ = local_world.get();
  world_ = std::move(local_world);
  seed_ = seed;
  robot_host_ = &host_.declare("robot", "robot", queue_);
  ASSIGN_OR_RETURN(auto robot, make_robot());
  host_.attach("robot", std::move(robot));
  gripper_host_ = &host_.declare("gripper", "gripper", queue_);
  host_.attach("gripper", make_gripper());
  return {};
}

Expected<std::unique_ptr<services::Component>> Cell::make_robot() {
  return robot::Robot::create(*robot_host_, local_world_->world(), static_cast<unsigned>(seed_));
}

std::unique_ptr<services::Component> Cell::make_gripper() {
  return std::make_unique<gripper::Gripper>(*gripper_host_, local_world_->world());
}

Expected<void> Cell::add_vision(const CellSetup& setup) {
  if (!local_world_->world().scene().camera) return {};
  auto& camera_host = host_.declare("camera", "KinectDriver", queue_);
  host_.attach("camera", std::make_unique<camera::Camera>(camera_host, local_world_->world(), setup.seed));
  const fs::path parts_path = fs::path(setup.folder) / "parts.json";
  const bool elsewhere = std::ranges::find(setup.remote, "recognition") != setup.remote.end();
  if (elsewhere) return {};
  ASSIGN_OR_RETURN(const bool has_parts, file_exists(parts_path));
  if (!has_parts) return {};
  ASSIGN_OR_RETURN(auto parts, recognition::load_parts(parts_path));
  auto& host = host_.declare("obj_rec", "ObjectRecognition", queue_);
  host_.attach("obj_rec", std::make_unique<recognition::ObjectRecognition>(host, std::move(parts)));
  return {};
}

Expected<void> Cell::add_database(const CellSetup& setup) {
  ASSIGN_OR_RETURN(auto store, open_store(setup.folder, setup.database));
  if (setup.own_threads) {
    database_queue_ = std::make_unique<services::WorkThread>("database");
    database_queue_->post(services::shorten_time_slice);
  }
  ASSIGN_OR_RETURN(start_values_, start_values(setup.folder));
  auto database =
      std::make_unique<database::Database>(std::move(store), host_.declare("db", "database", database_queue()));
  database_ = database.get();
  host_.attach("db", std::move(database));
  return {};
}

services::WorkQueue& Cell::database_queue() {
  if (database_queue_) return *database_queue_;
  return queue_;
}

Cell::~Cell() { stop(); }

void Cell::step() {
  work_in_step();
  if (before_step_) before_step_();
  if (local_world_) local_world_->step();
  clock_.set(static_cast<double>(++steps_) * kStep);
  host_.advance(waits_);
  work_in_step();
  host_.step(queue_);
  remotes_->step();
  if (local_world_) local_world_->publish_pose(clock_.now());
}

// In real time, no more than the step has room for, and little when it is late: who calls much has to wait, and time
// goes on for all others.
void Cell::work_in_step() {
  if (!is_real_time_) return static_cast<void>(queue_.run());
  using std::chrono::microseconds;
  constexpr microseconds kWork{300}, kLateWork{50}, kOther{100};
  const auto end = due_ + kPeriod - kOther;
  const auto left = std::chrono::duration_cast<microseconds>(end - std::chrono::steady_clock::now());
  queue_.run_for(std::clamp(left, kLateWork, kWork));
}

// Commands wait for no calls of cores.
void Cell::execute(const std::optional<PersonCommand>& command, Deadlines& deadlines, Done<Value> done) {
  const auto start = [&](CellWorld::Wanted wanted, CellWorld::Done executed) {
    auto work = [this, command, wanted = std::move(wanted), executed = std::move(executed)] {
      world_->execute(command, wanted, executed);
    };
    queue_.post(std::move(work), kPersonLane);
  };
  pending_commands_.start(start, deadlines, std::move(done));
}

void Cell::start_real_time() {
  is_real_time_ = true;
  thread_ = std::thread([this] {
    services::name_thread("cell");
    services::shorten_time_slice();
    due_ = std::chrono::steady_clock::now();
    while (!stop_) {
      due_ += kPeriod;
      std::this_thread::sleep_until(due_);
      const auto now = std::chrono::steady_clock::now();
      note_lateness(now - due_);
      if (now - due_ > kMostLate) due_ = now;
      take_step();
    }
  });
}

void Cell::note_lateness(std::chrono::steady_clock::duration late) {
  ++counted_steps_;
  if (late > kPeriod) ++late_steps_;
  const auto us = std::chrono::duration_cast<std::chrono::microseconds>(late).count();
  if (us > largest_late_us_) largest_late_us_ = us;
}

// What fails in each step is reported once.
void Cell::take_step() {
  try {
    step();
    failing_ = false;
  } catch (...) {
    if (!std::exchange(failing_, true)) services::report_failure("a step of the cell");
  }
}

void Cell::stop() {
  if (stop_.exchange(true)) return;
  if (thread_.joinable()) thread_.join();
  if (database_queue_) database_queue_->end();
  if (remotes_) remotes_->stop();
  host_.stop();
}

}  // namespace race::server
