// When what happens in the run of a core, for its time line: noted beside the journal, and written with it.
#include "server/execution/core.h"

namespace race::server {

// Of a macro step that no turn has begun: an edit, a forced value, the end by a person.
void Core::note_times(const execution::Progress& progress) {
  if (!timing_.has_begun(progress.position)) timing_.began(execution_, progress.entry, TimingRecorder::Clock::now());
  if (is_over()) timing_.ended(execution_);
  write_times_later();
}

void Core::service_changed(const std::string& service, const std::optional<std::string>& state) {
  if (timing_.service_changed(service, state)) write_times_later();
}

// If no macro step takes it along until then.
void Core::write_times_later() {
  if (times_due_.exchange(true)) return;
  resources_.deadlines.after(TimingRecorder::kInterval, [weak = weak_from_this()] {
    const auto core = weak.lock();
    if (core) core->strand_.post([core] { core->write_times(); });
  });
}

// Of what is durable. Not with the journal: a disk that fails here interrupts no run.
void Core::write_times() {
  times_due_ = false;
  if (closed_ || interruption_ || is_over() || run().position() == 0 || !timing_.has_news()) return;
  if (held_.size() > 0 || execution_.has_untold()) return write_times_later();
  resources_.writer.recover([self = shared_from_this(), block = timing_.take_block(execution_, 0)] {
    if (self->resources_.runs.add_timing(self->run_id_, block)) self->timing_.durable(0);
  });
}

void Core::note_services() {
  std::vector<ServiceChange> states;
  for (const std::string& key : program().services.declared_services()) {
    const auto status = resources_.host.service(key);
    if (status) states.push_back({0, key, status->available ? status->state : std::nullopt});
  }
  timing_.use(states);
}

}  // namespace race::server
