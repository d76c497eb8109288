#include "server/runs/run_keeper.h"

#include <future>
#include <utility>

#include "services/failures.h"

namespace race::server {

RunKeeper::~RunKeeper() {
  runs_.on_import({});
  strand_.post([this] { write_all(); });
}

void RunKeeper::connect(const Cores& cores, CellWorld* world) {
  cores_ = &cores;
  world_ = world;
  runs_.on_import([this] { apply_limits(); });
}

void RunKeeper::core_changed(const std::string& id, const Value& core) {
  const bool running = core.is_dict() && core.find("status")->as_string() == "running";
  {
    const services::MutexLock lock(mutex_);
    const bool changed = running ? running_.insert(id).second : running_.erase(id) > 0;
    if (changed && world_) world_->record_pose(!running_.empty());
  }
  if (running || (core.is_dict() && !core.find("results"))) return;
  apply_limits();  // the run is over, or its core was removed
}

void RunKeeper::record(const Value& pose) {
  const double time = pose.find("time")->to_double();
  if (time < due_ && due_ <= time + kInterval) return;  // the second: a world that came back begins anew
  due_ = time + kInterval;
  if (poses_ >= kMostWaiting) return;
  strand_.post([this, pose] {
    --poses_;
    take(pose);
  });
  ++poses_;  // it may be taken already
}

void RunKeeper::take(const Value& pose) {
  for (const auto& core : cores_->all()) {
    const Value info = core->info();
    if (info.find("status")->as_string() != "running" || info.find("paused")->as_bool()) continue;
    std::vector<Sample>& waiting = waiting_[core->run_id()];
    waiting.push_back({static_cast<std::uint64_t>(info.find("step")->as_integer()), pose});
    if (waiting.size() >= kWritten) write(core->run_id());
  }
}

void RunKeeper::flush() {
  std::promise<void> written;
  strand_.post([&] {
    services::run_reporting("writing the samples", [this] { write_all(); });
    written.set_value();
  });
  written.get_future().wait();
}

void RunKeeper::write_all() {
  while (!waiting_.empty()) write(waiting_.begin()->first);
}

void RunKeeper::write(RunId run) {
  const auto waiting = waiting_.extract(run);
  if (auto stored = samples_.append(run, waiting.mapped()); !stored) log_(LogLevel::error, to_string(stored.error()));
}

void RunKeeper::apply_limits() {
  if (limits_due_.exchange(true)) return;
  strand_.post([this] {
    limits_due_ = false;
    write_all();
    const auto hosted = [this](RunId id) { return cores_->find(std::to_string(id)).has_value(); };
    const auto removed = apply_retention(runs_, limits_, hosted);
    if (!removed)
      log_(LogLevel::error, to_string(removed.error()));
    else if (*removed > 0)
      log_(LogLevel::info, "removed the oldest runs: " + std::to_string(*removed));
  });
}

}  // namespace race::server
