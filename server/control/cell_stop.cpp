#include "server/control/cell_stop.h"

#include "services/failures.h"

namespace race::server {

namespace {

constexpr std::chrono::milliseconds kAgain{100};

}  // namespace

CellStop::CellStop(Control& control, services::Host& host, Cores& cores, Marks marks, Log log)
    : control_(control), host_(host), cores_(cores), marks_(std::move(marks)), log_(std::move(log)) {
  if (auto before = marks_.stop.read()) control_.stop(std::move(*before));
  control_.set_mode(marks_.mode.read());
  if (control_.mode() == Mode::programming) limit_speed(Mode::programming);
}

bool CellStop::stop(const std::string& by, std::int64_t now) {
  const bool is_first = control_.stop({by, now});
  // One more stop calls again what is safe, as a person who presses again expects; a flood of them does nothing more.
  const auto called = std::chrono::steady_clock::now();
  if (!is_first && called < called_.load() + kAgain) return false;
  called_ = called;
  host_.call_safe();
  if (!is_first) return false;  // no run has begun since
  write_stop();
  pool_.post([this, by] {
    end_runs();
    log_("stopped by " + by);
  });
  return true;
}

bool CellStop::reset(const std::string& by) {
  if (!control_.reset()) return false;
  write_stop();
  pool_.post([this, by] { log_("reset by " + by); });
  return true;
}

void CellStop::halt(const Control::Ended& ended, const std::string& why) {
  for (const std::string& id : ended.cores)
    if (const auto core = cores_.find(id)) (*core)->hold_at_once();
  if (!ended.services.empty()) host_.call_safe(ended.services);
  if (!ended.services.empty() || !ended.cores.empty()) pool_.post([this, why] { log_("stops: " + why); });
}

// Slow before anything can move by hand, and until nothing can any more: what refuses the change leaves the limit of
// the mode that stays.
Expected<void> CellStop::set_mode(std::uint64_t number, Mode mode) {
  if (auto holds = control_.fence_of(number); !holds) return tl::unexpected(std::move(holds).error());
  Control::Ended ended;
  {
    const services::MutexLock lock(modes_mutex_);
    if (mode == Mode::programming) limit_speed(mode);
    auto changed = control_.set_mode(number, mode);
    if (!changed || mode != Mode::programming) limit_speed(control_.mode());
    if (!changed) return tl::unexpected(std::move(changed).error());
    ended = *std::move(changed);
    write_mode();
  }
  halt(ended, ended.by + " has set the mode: " + std::string(name(mode)));
  return {};
}

void CellStop::end() {
  pool_.end();
  disk_.end();
}

void CellStop::limit_speed(Mode mode) {
  host_.limit_speed(mode == Mode::programming ? std::optional(kReducedSpeed) : std::nullopt);
}

// What is written is what holds then: of a stop and a reset, and of two modes, the later.
void CellStop::write_stop() {
  disk_.post([this] {
    if (auto written = marks_.stop.write(control_.stopped()); !written) log_(to_string(written.error()));
  });
}

// One write waits at most, however often the mode changes.
void CellStop::write_mode() {
  if (mode_waits_.exchange(true)) return;
  disk_.post([this] {
    mode_waits_ = false;
    if (auto written = marks_.mode.write(control_.mode()); !written) log_(to_string(written.error()));
  });
}

// One that was not started is told nothing: it stays ready.
void CellStop::end_runs() {
  for (const auto& core : cores_.all())
    services::run_reporting("the end of a run", [&] { core->stop([](const Expected<Value>&) {}); });
}

}  // namespace race::server
