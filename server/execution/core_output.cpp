// What leaves a core: entries to the journal at once, everything else when they are durable.
#include <algorithm>
#include <bit>

#include "core/execution/checkpoint.h"
#include "core/execution/step_json.h"
#include "server/execution/core.h"
#include "server/execution/outgoing_calls.h"
#include "server/wire/calendar.h"
#include "services/computed_time.h"

namespace race::server {

using execution::Progress;

namespace {

Value integer(std::uint64_t n) { return static_cast<std::int64_t>(n); }

std::size_t units_of(const execution::JournalEntry& entry) {
  if (const auto* event = std::get_if<execution::EventEntry>(&entry)) return event->data.size_units();
  if (const auto* response = std::get_if<execution::ResponseEntry>(&entry)) return response->data.size_units();
  return 0;
}

std::size_t units_of(const std::vector<std::string>& texts) {
  std::size_t units = 0;
  for (const std::string& text : texts) units += text.size();
  return units;
}

std::size_t units_of(const std::vector<semantics::OutgoingCall>& calls) {
  std::size_t units = 0;
  for (const semantics::OutgoingCall& call : calls) {
    for (const Value& argument : call.args) units += argument.size_units();
    for (const auto& [name, argument] : call.kwargs) units += argument.size_units();
  }
  return units;
}

template <typename T>
std::vector<T> part(const std::vector<T>& all, std::size_t first, std::size_t most = ~std::size_t{0}) {
  const auto begin = all.begin() + static_cast<std::ptrdiff_t>(first);
  return {begin, begin + static_cast<std::ptrdiff_t>(std::min(most, all.size() - first))};
}

}  // namespace

// What came of a part of a macro step: the one place where anything leaves a core.
void Core::emit(const Progress& progress) {
  note_times(progress);
  record(progress);
  const Value delta = execution_.is_watched() && !progress.edited ? delta_of(progress) : Value();
  const Value steps = progress.derivation ? steps_of(progress) : Value();
  const bool stands = paused_ || is_over();
  const Value info = !delta.is_null() ? *delta.find("core") : stands ? info_json() : Value();
  const auto [first_print, first_call] = hold_many(progress);
  auto printed = part(progress.printed, first_print);
  auto calls = part(progress.calls, first_call);
  std::size_t units = units_of(printed) + units_of(calls) + delta.size_units() + steps.size_units();
  if (progress.entry && progress.begins) units += units_of(*progress.entry);
  held_.add(
      [this, reached = reached_now(), calls = std::move(calls), over = is_over(), printed = std::move(printed), delta,
       steps, info, fence = fence_](const Error* failure) {
        if (failure) return;
        set_reached(reached);
        if (!info.is_null()) keep_info(info);  // first: who hears of something and asks at once is told no less
        for (const std::string& text : printed) resources_.watcher.printed(id_, text);
        make_calls(resources_.host, id_, fence, calls, over);
        if (!delta.is_null()) resources_.watcher.state_changed(id_, delta);
        if (!steps.is_null()) resources_.watcher.derived(id_, steps);
      },
      units);
  if (progress.edited && execution_.is_watched()) publish_snapshot(&CoreWatcher::state_replaced);
  if (stands) publish_info();
}

// What is more than one piece of what a macro step prints and calls, and is said before the rest of it. Returns how
// many prints and calls that are.
std::pair<std::size_t, std::size_t> Core::hold_many(const Progress& progress) {
  std::size_t print = 0, call = 0;
  const std::size_t rest = progress.calls.size() > kPiece ? 0 : kPiece;  // of the prints, that are said with the rest
  for (; progress.printed.size() > print + rest; print += kPiece) {
    auto texts = part(progress.printed, print, kPiece);
    const std::size_t units = units_of(texts);
    held_.add(
        [this, texts = std::move(texts)](const Error* failure) {
          if (failure) return;
          for (const std::string& text : texts) resources_.watcher.printed(id_, text);
        },
        units);
  }
  for (; progress.calls.size() > call + kPiece; call += kPiece) {
    auto calls = part(progress.calls, call, kPiece);
    const std::size_t units = units_of(calls);
    held_.add(
        [this, calls = std::move(calls), fence = fence_](const Error* failure) {
          if (!failure) make_calls(resources_.host, id_, fence, calls, false);
        },
        units);
  }
  return {std::min(print, progress.printed.size()), call};
}

// Some of what is durable, then the others have their turn.
void Core::say_due() {
  const bool was_ahead = held_.is_full();
  const auto end = services::thread_time() + kSayTime;
  while (held_.is_due() && services::thread_time() < end) held_.say_next();
  if (held_.is_due()) go_on_saying();
  if (was_ahead && !held_.is_full()) schedule();
}

// With the rest of turns if the core is busy, unless somebody waits for an answer.
void Core::go_on_saying() {
  const bool hurries = held_.has_answers() || !is_busy();
  if (std::exchange(saying_, true) && !hurries) return;
  Work go_on = measured([this] {
    saying_ = false;
    say_due();
  });
  try {
    if (hurries) return strand_.post(std::move(go_on));
    strand_.post_later(std::move(go_on));
  } catch (...) {  // no memory: what becomes durable next goes on
    saying_ = false;
    throw;
  }
}

// The entry with the first part of its macro step; after the last part, the checkpoint that is due and the run's end.
void Core::record(const Progress& progress) {
  JournalRecord record;
  if (progress.begins) record.entry = progress.entry;
  if (progress.complete && is_over())
    record.end = run_end();
  else if (progress.complete && progress.position % RunJournal::interval_at(progress.position) == 0)
    record.checkpoint = checkpoint_json(execution_);
  if (!record.entry && !record.checkpoint && !record.end) return;
  if (record.checkpoint) record.checkpoint->freeze();
  record.ticket = held_.next_ticket();
  if (record.end || timing_.is_due()) record.timing = timing_.take_block(execution_, record.ticket);
  resources_.writer.append(journal_, record);
}

RunEnd Core::run_end() const {
  RunEnd end{
      std::string(semantics::name(run().status())), run().outcome(), {}, execution::root_results(run()), now_ms()};
  if (run().fault()) end.fault = execution::fault_json(*run().fault());
  end.fault.freeze();
  end.results.freeze();
  return end;
}

// schemas/core_delta.json
Value Core::delta_of(const Progress& progress) const {
  Dict delta{{"core", info_json()}};
  if (progress.entry) delta.set("input", input_json(*progress.entry));
  for (const auto& [key, value] : progress.delta) delta.set(key, value);
  delta.set("calls", execution::calls_json(progress.calls));
  Value frozen = std::move(delta);
  return std::move(frozen.freeze());
}

Value Core::steps_of(const Progress& progress) const {
  Dict step = trace_step(program(), progress);
  step.set("first", integer(progress.first));
  step.set("complete", progress.complete);
  Value steps = Dict{{"steps", List{Value(std::move(step))}}};
  return std::move(steps.freeze());
}

void Core::watch_state() {
  state_watched_ = true;
  if (state_asked_.exchange(true)) return;
  strand_.post([self = shared_from_this()] { self->publish_snapshot(&CoreWatcher::state_snapshot); });
}

void Core::publish_snapshot(void (CoreWatcher::*publish)(const std::string&, Value)) {
  tell_untold();
  Value snapshot = Dict{{"core", info_json()}, {"state", execution_.watch()}};
  snapshot.freeze();
  held_.add([this, snapshot, publish](const Error* failure) {
    state_asked_ = false;
    if (!failure) (resources_.watcher.*publish)(id_, snapshot);
  });
}

void Core::watch_derivation(bool on) {
  derivation_watched_ = on;
  if (!on || derivation_asked_.exchange(true)) return;
  strand_.post([self = shared_from_this()] { self->publish_next_derivation(); });
}

void Core::publish_next_derivation() {
  derivation_asked_ = false;
  Value next = Dict{{"next", integer(run().position() + 1)}};
  next.freeze();
  held_.add([this, next](const Error* failure) {
    if (!failure) resources_.watcher.derivation_snapshot(id_, next);
  });
}

// What it has computed and cannot store has not happened.
void Core::publish_info() {
  if (!readable()) return publish_interruption();
  held_.add([this, info = info_json()](const Error* failure) {
    if (!failure) set_info(info);
  });
}

void Core::keep_info(Value info) {
  const services::MutexLock lock(mutex_);
  info_ = std::move(info);
}

void Core::set_info(Value info) {
  keep_info(info);
  // Counters move with every input; the list of cores hears of what else changes.
  Dict news = info.as_dict();
  for (const char* counter : {"step", "micro", "waiting"}) news.erase(counter);
  // Nor does who watches a paused one learn from its steps that ever more wait.
  if (info.find("paused")->as_bool())
    news.set("waiting",
             static_cast<int>(std::bit_width(static_cast<std::uint64_t>(info.find("waiting")->as_integer()))));
  if (Value(news) == announced_) return;
  announced_ = std::move(news);
  resources_.watcher.core_changed(id_, std::move(info));
}

Value Core::info_json() const {
  const bool over = is_over();
  Dict info{{"id", id_}, {"document", record_.document}, {"revision", revision_}};
  execution::set_status(run(), info);
  if (!started_) info.set("status", "ready");
  if (interruption_) {
    info.set("status", "interrupted");
    info.set("interruption", Dict{{"reason", interruption_->reason}, {"message", interruption_->message}});
  }
  info.set("paused", (paused_ || awaits_input()) && !over);
  info.set("stepping", execution_.has_goal() && !over);
  if (supervised_ && !over) info.set("supervised", true);
  info.set("step", integer(run().position()));
  info.set("micro", integer(execution_.micro()));
  info.set("waiting", integer(execution_.waiting().size()));
  for (const auto& [key, value] : edit_info()) info.set(key.as_string(), value);
  info.set("arguments", header_.arguments);
  info.set("breakpoints", breakpoints_json(breakpoints_));
  if (!reached_breakpoints_.empty()) info.set("reached", reached_breakpoints_);
  if (over) info.set("results", execution::root_results(run()));
  Value frozen = std::move(info);
  return std::move(frozen.freeze());
}

}  // namespace race::server
