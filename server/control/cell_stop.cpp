#include "server/control/cell_stop.h"

#include "services/failures.h"

namespace race::server {

namespace {

constexpr std::int64_t kAgain = 100;  // [ms]

}  // namespace

CellStop::CellStop(Control& control, services::Host& host, Cores& cores, Marks marks, Log log)
    : control_(control), host_(host), cores_(cores), marks_(std::move(marks)), log_(std::move(log)) {
  if (auto before = marks_.stop.read()) control_.stop(std::move(*before));
  control_.set_mode(marks_.mode.read());
  if (control_.mode() == Mode::programming) limit_speed(Mode::programming);
}

void CellStop::stop(const std::string& by, std::int64_t now) {
  const bool is_first = control_.stop({by, now});
  // One more stop calls again what is safe, as a person who presses again expects; a flood of them does nothing more.
  if (!is_first && now < called_ + kAgain) return;
  called_ = now;
  host_.call_safe();
  if (!is_first) return;  // no run has begun since
  pool_.post([this, by] {
    end_runs();
    follow("stopped by " + by);
  });
}

void CellStop::reset(const std::string& by) {
  control_.reset();
  pool_.post([this, by] { follow("reset by " + by); });
}

void CellStop::halt(const Control::Ended& ended, const std::string& why) {
  for (const std::string& id : ended.cores)
    if (const auto core = cores_.find(id)) (*core)->hold_at_once();
  if (!ended.services.empty()) host_.call_safe(ended.services);
  if (!ended.services.empty() || !ended.cores.empty()) pool_.post([this, why] { log_("stops: " + why); });
}

// Slow before anything can move in it.
void CellStop::change_mode(const Control::Ended& ended, Mode mode, const std::string& by) {
  limit_speed(mode);
  const std::string mode_name(name(mode));
  halt(ended, by + " has set the mode: " + mode_name);
  pool_.post([this, mode] {
    if (auto written = marks_.mode.write(mode); !written) log_(to_string(written.error()));
  });
}

void CellStop::limit_speed(Mode mode) {
  host_.limit_speed(mode == Mode::programming ? std::optional(kReducedSpeed) : std::nullopt);
}

// What is written is what holds then: of a stop and a reset, the later.
void CellStop::follow(const std::string& text) {
  log_(text);
  if (auto written = marks_.stop.write(control_.stopped()); !written) log_(to_string(written.error()));
}

// One that was not started is told nothing: it stays ready.
void CellStop::end_runs() {
  for (const auto& core : cores_.all())
    services::run_reporting("the end of a run", [&] { core->stop([](const Expected<Value>&) {}); });
}

}  // namespace race::server
