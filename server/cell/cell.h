// Cell: the services of this process and the world they act in, with one host and one clock. Its group steps at 1 kHz:
// either paced by real time on a thread of its own, or by whoever calls step(), as fast as that goes.
//
// Threads: without start_real_time(), one: the caller's. With it, the group's thread is the cell's own.
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <thread>

#include "core/value/expected.h"
#include "core/value/value.h"
#include "server/cell/cell_file.h"
#include "server/cell/local_world.h"
#include "server/cell/pending_commands.h"
#include "services/host/host.h"
#include "services/remote/remotes.h"

namespace race::database {
class Database;
}

namespace race::server {

/// One more service of a cell, in its group, or in a process of its own if that is a group of CellSetup::remote.
struct ExtraService {
  std::string key, type;
  std::function<std::unique_ptr<services::Component>(services::ServiceHost&)> make;
  remote::HostFunctions host_functions = {};  // what the process asks
};

struct CellSetup {
  std::string folder;    // of the cell (cell_file.h); empty: none
  std::string database;  // file of the database, or ":memory:"
  // The database has a thread of its own, and world time waits for nobody. Else all services are one group, and world
  // time waits for answers that are due, so that a seed gives one run.
  bool own_threads = true;
  std::vector<ExtraService> extra_services = {};
  std::vector<std::string> remote =
      {};  // names of the groups (component_groups.h) that wait for a process of their own
  bool own_services =
      false;  // processes may bring services: those that the cell expects, and their own as it lets them
  std::chrono::milliseconds heartbeat{1000};  // how long such a process may be silent
  services::MotionGate* gate = nullptr;       // of the host; outlives the cell
  std::uint64_t seed = 0;                     // of everything that is random; the same seed gives the same run
  bool has_world = true;                      // else its scene is not loaded, and services lack it
  std::vector<ExtraService> stand_ins = {};  // services in place of those of the cell with these keys, and further ones
};

class Cell {
 public:
  static constexpr double kStep = world::World::kStep;

  /// Builds the world and the services that the cell names. Without a cell.json those are all for which there are
  /// files: `robot` and `gripper` in a scene, `camera` if that has one and `obj_rec` if there are parts, too; `db`,
  /// `timer` and those of `extra_services`. Values of the cell whose keys the database does not have are added to it.
  /// Errors: those of read_cell(); `missing`: a service that the cell names lacks something; `io`, and those of the
  /// files.
  static Checked<std::unique_ptr<Cell>> create(const CellSetup& setup, services::HostObserver& observer);
  ~Cell();
  Cell(const Cell&) = delete;
  Cell& operator=(const Cell&) = delete;

  /// What its folder says that it is.
  const CellFile& file() const { return file_; }
  services::Host& host() { return host_; }
  /// The services whose components live in other processes.
  remote::Remotes& remotes() { return *remotes_; }
  const services::Clock& clock() const { return clock_; }
  /// The world of the cell; none: it has no scene, and is no process.
  CellWorld* world() { return world_.get(); }
  /// The world, if it is in this process.
  const LocalWorld* local_world() const { return local_world_; }
  /// CellWorld::execute(), from any thread; the result goes to `done` (pending_commands.h). Only with a world, and
  /// after start_real_time(). Errors: `unavailable`, those of the command.
  void execute(const std::optional<PersonCommand>& command, Deadlines& deadlines, Done<Value> done);
  /// Puts world, robot and gripper back to the scene of the start and lets all hands go, and, if `wants_database` and
  /// the cell has one, makes start_values() the only ones of the database, which comes first. What waits for an answer
  /// of robot or gripper is answered `unavailable`. Gives what hands hold then to `done`; from any thread, as
  /// execute(). A core that executes would not expect it: its caller knows of none. Errors: `conflict`, the world or
  /// the database is a process of its own, or another reset is not done yet; those of execute() and of the database.
  void reset(bool wants_database, Deadlines& deadlines, Done<Value> done);
  /// Called at the beginning of each step(), on the group's thread. To be set before the first step.
  void before_step(std::function<void()> work) { before_step_ = std::move(work); }

  /// Does what was called since; no time passes. Whether there was anything.
  bool work() { return queue_.run(); }
  /// One step of the world and its services, 1 ms.
  void step();

  /// Steps in real time until stop(). If the machine falls behind by more than 100 ms, world time waits for it.
  void start_real_time();
  /// Of steps in real time: how many, those that began more than a step too late, and how late the latest was.
  struct Lateness {
    std::uint64_t steps = 0, late = 0;
    std::chrono::microseconds largest{0};
  };
  Lateness lateness() const { return {counted_steps_, late_steps_, std::chrono::microseconds(largest_late_us_)}; }
  /// The groups end; nothing is called on a service afterwards.
  void stop();

 private:
  static constexpr services::WorkQueue::Lane kPersonLane = 2;  // those of cores are odd
  static constexpr std::chrono::milliseconds kPeriod{1};       // of steps
  static constexpr std::chrono::milliseconds kMostLate{100};

  Cell(CellFile file, services::HostObserver& observer, services::MotionGate* gate)
      : file_(std::move(file)), host_(clock_, observer, gate) {}
  Expected<void> build(const CellSetup& setup);
  void take_step();
  void note_lateness(std::chrono::steady_clock::duration late);
  void work_in_step();
  Expected<void> add_remotes(const CellSetup& setup);
  void add_absent();
  Expected<void> add_world(const CellSetup& setup);
  Expected<void> add_service(const CellFile::Service& service, const CellSetup& setup);
  Expected<void> add_robot(const std::string& key, const CellSetup& setup);
  Expected<void> add_gripper(const std::string& key, const CellSetup& setup);
  Expected<void> add_camera(const std::string& key, const CellSetup& setup);
  Expected<void> add_recognition(const std::string& key, const CellSetup& setup);
  Expected<void> add_database(const std::string& key, const CellSetup& setup);
  Expected<void> add_timer(const std::string& key, const CellSetup& setup);
  void add_extra(const ExtraService& service, const std::string& key);
  Expected<bool> is_there(bool it, const std::string& key, const char* what) const;
  Expected<void> check_resettable(bool with_database) const;
  class Reset;
  Expected<std::shared_ptr<Reset>> begin_reset();
  Expected<Value> reset_world();
  Expected<std::unique_ptr<services::Component>> make_robot();
  std::unique_ptr<services::Component> make_gripper();
  services::WorkQueue& database_queue();

  const CellFile file_;
  services::WorldClock clock_;
  services::WorkQueue queue_;
  std::unique_ptr<services::WorkThread> database_queue_;
  std::unique_ptr<CellWorld> world_;
  LocalWorld* local_world_ = nullptr;                                      // world_, if it is in this process
  services::ServiceHost *robot_host_ = nullptr, *gripper_host_ = nullptr;  // if they are
  std::uint64_t seed_ = 0;                                                 // of the robot
  database::Database* database_ = nullptr;                                 // the host's, if it is in this process
  Dict start_values_;                                                      // of it
  PendingCommands pending_commands_;
  const std::shared_ptr<std::atomic<bool>> resetting_ = std::make_shared<std::atomic<bool>>(false);  // held by a reset
  services::Host host_;
  std::unique_ptr<remote::Remotes> remotes_;
  std::int64_t steps_ = 0;
  bool is_real_time_ = false;
  std::chrono::steady_clock::time_point due_;  // in real time: when the step was to begin
  bool waits_ = false;                         // for answers that are due
  bool failing_ = false;                       // the last step was, of take_step()
  std::function<void()> before_step_;
  std::atomic<std::uint64_t> counted_steps_{0}, late_steps_{0};  // written by the cell's thread alone
  std::atomic<std::int64_t> largest_late_us_{0};
  std::atomic<bool> stop_{false};
  std::thread thread_;
};

}  // namespace race::server
