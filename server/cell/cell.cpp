#include "server/cell/cell.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <string_view>
#include <utility>

#include "server/cell/component_groups.h"
#include "server/cell/remote_world_proxy.h"
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

Checked<std::unique_ptr<Cell>> Cell::create(const CellSetup& setup, services::HostObserver& observer) {
  auto file = read_cell(setup.folder);
  if (!file) return tl::unexpected(std::move(file).error());
  std::unique_ptr<Cell> cell(new Cell(std::move(*file), observer, setup.gate));
  if (auto built = cell->build(setup); !built) return tl::unexpected(std::vector<Error>{std::move(built).error()});
  return cell;
}

Expected<void> Cell::build(const CellSetup& setup) {
  waits_ = !setup.own_threads;
  for (const ExtraService& service : setup.stand_ins) add_extra(service, service.key);
  if (auto added = add_remotes(setup); !added) return added;
  if (!world_ && setup.has_world)
    if (auto added = add_world(setup); !added) return added;
  for (const CellFile::Service& service : file_.services)
    if (auto added = add_service(service, setup); !added) return added;
  for (const ExtraService& service : setup.extra_services)
    if (!is_known_type(service.type)) add_extra(service, service.key);  // no file can name it
  return {};
}

Expected<void> Cell::add_remotes(const CellSetup& setup) {
  remotes_ = std::make_unique<remote::Remotes>(host_, clock_, setup.heartbeat);
  for (const std::string& name : setup.remote) {
    ASSIGN_OR_RETURN(const ComponentGroup* group, find_component_group(name));
    std::vector<remote::RemoteService> services = services_of(*group, file_);
    for (remote::RemoteService& service : services)
      for (const ExtraService& extra : setup.extra_services)
        if (extra.type == service.type) service.host_functions = extra.host_functions;
    remote::RemoteWorld* world = nullptr;
    if (group->world) {
      auto proxy = std::make_unique<RemoteWorldProxy>(clock_);
      world = &proxy->end();
      world_ = std::move(proxy);
    }
    remotes_->add(name, services, world);
  }
  if (!setup.own_services) return add_absent(), Expected<void>();
  std::vector<remote::RemoteService> expected;
  for (const CellFile::Awaited& each : file_.expects) expected.push_back({each.key, each.type, &each.model});
  remotes_->add_own(expected, file_.accounts);
  return {};
}

// No process can bring what the cell expects: tasks are checked against it, and are answered `unavailable`.
void Cell::add_absent() {
  for (const CellFile::Awaited& each : file_.expects) {
    if (host_.has(each.key)) continue;
    services::ServiceHost& host = host_.declare(each.key, each.type, queue_);
    const std::shared_ptr<const rsm::Service> model(std::shared_ptr<const void>(), &each.model);  // the file's
    host_.attach(each.key, std::make_unique<remote::RemoteComponent>(each.key, model, host),
                 services::Host::Connection::disconnected);
  }
}

Expected<void> Cell::add_world(const CellSetup& setup) {
  ASSIGN_OR_RETURN(const bool has_scene, file_.has(file_.scene));
  if (!has_scene) return {};
  ASSIGN_OR_RETURN(auto local_world, LocalWorld::load(file_.scene));
  local_world_ = local_world.get();
  world_ = std::move(local_world);
  seed_ = setup.seed;
  return {};
}

// Those that processes bring, and those for which others stand, are there already.
Expected<void> Cell::add_service(const CellFile::Service& service, const CellSetup& setup) {
  using Add = Expected<void> (Cell::*)(const std::string& key, const CellSetup& setup);
  static const std::map<std::string_view, Add> kAdd = {
      {kRobotType, &Cell::add_robot},       {kGripperType, &Cell::add_gripper},
      {kCameraType, &Cell::add_camera},     {kRecognitionType, &Cell::add_recognition},
      {kDatabaseType, &Cell::add_database}, {kTimerType, &Cell::add_timer}};
  if (host_.has(service.key)) return {};
  const auto add = kAdd.find(service.type);
  if (add != kAdd.end()) return (this->*add->second)(service.key, setup);
  const auto extra = std::ranges::find(setup.extra_services, service.type, &ExtraService::type);
  if (extra != setup.extra_services.end()) add_extra(*extra, service.key);
  return {};
}

// Whether what the service `key` needs is here. If the cell's world is a process, it may be there.
Expected<bool> Cell::is_there(bool it, const std::string& key, const char* what) const {
  if (it || (world_ && !local_world_)) return it;
  if (auto lacking = file_.lacks(key, what); !lacking) return tl::unexpected(std::move(lacking).error());
  return false;
}

Expected<void> Cell::add_robot(const std::string& key, const CellSetup&) {
  ASSIGN_OR_RETURN(const bool possible, is_there(local_world_ != nullptr, key, "a scene"));
  if (!possible) return {};
  robot_host_ = &host_.declare(key, std::string(kRobotType), queue_);
  ASSIGN_OR_RETURN(auto robot, make_robot());
  host_.attach(key, std::move(robot));
  return {};
}

Expected<void> Cell::add_gripper(const std::string& key, const CellSetup&) {
  ASSIGN_OR_RETURN(const bool possible, is_there(local_world_ != nullptr, key, "a scene"));
  if (!possible) return {};
  gripper_host_ = &host_.declare(key, std::string(kGripperType), queue_);
  host_.attach(key, make_gripper());
  return {};
}

Expected<void> Cell::add_camera(const std::string& key, const CellSetup& setup) {
  const bool has_camera = local_world_ && local_world_->world().scene().camera;
  ASSIGN_OR_RETURN(const bool possible, is_there(has_camera, key, "a scene with a camera"));
  if (!possible) return {};
  auto& host = host_.declare(key, std::string(kCameraType), queue_);
  host_.attach(key, std::make_unique<camera::Camera>(host, local_world_->world(), setup.seed));
  return {};
}

Expected<void> Cell::add_recognition(const std::string& key, const CellSetup&) {
  const bool has_camera = local_world_ && local_world_->world().scene().camera;
  ASSIGN_OR_RETURN(const bool sees, is_there(has_camera, key, "a scene with a camera"));
  if (!sees) return {};
  ASSIGN_OR_RETURN(const bool has_parts, file_.has(file_.parts));
  ASSIGN_OR_RETURN(const bool knows, is_there(has_parts, key, "parts"));
  if (!knows) return {};
  ASSIGN_OR_RETURN(auto parts, recognition::load_parts(file_.parts));
  auto& host = host_.declare(key, std::string(kRecognitionType), queue_);
  host_.attach(key, std::make_unique<recognition::ObjectRecognition>(host, std::move(parts)));
  return {};
}

Expected<void> Cell::add_database(const std::string& key, const CellSetup& setup) {
  ASSIGN_OR_RETURN(auto store, open_store(file_, setup.database));
  if (setup.own_threads) {
    database_queue_ = std::make_unique<services::WorkThread>("database");
    database_queue_->post(services::shorten_time_slice);
  }
  ASSIGN_OR_RETURN(start_values_, start_values(file_));
  auto& host = host_.declare(key, std::string(kDatabaseType), database_queue());
  auto database = std::make_unique<database::Database>(std::move(store), host);
  database_ = database.get();
  host_.attach(key, std::move(database));
  return {};
}

Expected<void> Cell::add_timer(const std::string& key, const CellSetup&) {
  auto& host = host_.declare(key, std::string(kTimerType), queue_);
  host_.attach(key, std::make_unique<timer::Timer>(host));
  return {};
}

void Cell::add_extra(const ExtraService& service, const std::string& key) {
  if (host_.has(key)) return;  // its process brings it
  host_.attach(key, service.make(host_.declare(key, service.type, queue_)));
}

Expected<std::unique_ptr<services::Component>> Cell::make_robot() {
  return robot::Robot::create(*robot_host_, local_world_->world(), static_cast<unsigned>(seed_));
}

std::unique_ptr<services::Component> Cell::make_gripper() {
  return std::make_unique<gripper::Gripper>(*gripper_host_, local_world_->world());
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
