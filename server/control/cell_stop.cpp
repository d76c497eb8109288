#include "server/control/cell_stop.h"

#include "services/failures.h"

namespace race::server {

namespace {

constexpr std::int64_t kAgain = 100;  // [ms]

}  // namespace

CellStop::CellStop(Control& control, services::Host& host, Cores& cores, StopMark mark, Log log)
    : control_(control), host_(host), cores_(cores), mark_(std::move(mark)), log_(std::move(log)) {
  if (auto before = mark_.read()) control_.stop(std::move(*before));
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

// What is written is what holds then: of a stop and a reset, the later.
void CellStop::follow(const std::string& text) {
  log_(text);
  if (auto written = mark_.write(control_.stopped()); !written) log_(to_string(written.error()));
}

// One that was not started is told nothing: it stays ready.
void CellStop::end_runs() {
  for (const auto& core : cores_.all())
    services::run_reporting("the end of a run", [&] { core->stop([](const Expected<Value>&) {}); });
}

}  // namespace race::server
