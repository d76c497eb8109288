#include "server/execution/timing_recorder.h"

#include <algorithm>
#include <utility>

#include "core/execution/journal_input.h"

namespace race::server {

using execution::entry_of;
using execution::EventEntry;
using execution::Execution;
using execution::JournalEntry;
using execution::ResponseEntry;
using semantics::Input;

namespace {

constexpr Moment kNever{std::numeric_limits<std::uint64_t>::max(), Moment::kEnd};

bool is_same_event(const JournalEntry& a, const JournalEntry& b) {
  const auto *event = std::get_if<EventEntry>(&a), *other = std::get_if<EventEntry>(&b);
  return event && other && event->service == other->service && event->event == other->event;
}

// No two inputs that wait answer one call.
bool is_same(const JournalEntry& a, const JournalEntry& b) {
  const auto *response = std::get_if<ResponseEntry>(&a), *other = std::get_if<ResponseEntry>(&b);
  return response ? other && response->call == other->call : is_same_event(a, b);
}

const Value& data_of(const JournalEntry& input) {
  if (const auto* event = std::get_if<EventEntry>(&input)) return event->data;
  return std::get<ResponseEntry>(input).data;
}

JournalEntry entry_at(const Execution& execution, std::size_t number) {
  Input input = execution.waiting().inputs()[number];
  return entry_of(execution.run(), input);
}

}  // namespace

TimingRecorder::TimingRecorder(std::int64_t age_ms, std::uint64_t steps)
    : made_(Clock::now() - std::chrono::milliseconds(std::max<std::int64_t>(0, age_ms))) {
  block_.since = steps > 0 ? kNever : Moment{0, 0};
  block_.first = steps + 1;
  block_.begins = block_.ends = time_of(Clock::now());
}

std::int64_t TimingRecorder::time_of(Clock::time_point time) const {
  return std::chrono::duration_cast<std::chrono::microseconds>(time - made_).count();
}

Moment TimingRecorder::moment_of(const Execution& execution) {
  return {execution.run().position(), execution.is_open() ? execution.micro() : Moment::kEnd};
}

// What came and went within one moment was never seen to wait.
void TimingRecorder::drop(Waiting&& waiting, Moment from) {
  if (waiting.arrival.moment >= from) return;
  const std::size_t units = data_of(waiting.input).size_units();
  if (block_.undelivered.size() >= TimingBlock::kMostUndelivered ||
      undelivered_units_ + units > TimingBlock::kUndeliveredUnits) {
    block_.since = std::max(block_.since, from);  // too much to be kept: what waited before is not known
    return;
  }
  undelivered_units_ += units;
  block_.undelivered.push_back({std::move(waiting.input), waiting.arrival, from});
}

void TimingRecorder::drop_all(Moment from) {
  for (Waiting& each : waiting_) drop(std::move(each), from);
  waiting_.clear();
}

// Those that wait are some of those that waited, in the same order, and perhaps others at the end. Of equal ones the
// last stay (a sample).
void TimingRecorder::align(const Execution& execution, Moment dropped, Moment now) {
  const std::size_t size = execution.waiting().size();
  std::deque<Waiting> before = std::exchange(waiting_, {});
  std::deque<Waiting> kept;
  for (std::size_t i = size; i-- > 0;) {
    const JournalEntry input = entry_at(execution, i);
    std::size_t found = before.size();
    while (found > 0 && !is_same(before[found - 1].input, input)) --found;
    if (found == 0) {
      kept.push_front({input, {time_of(Clock::now()), now}});
      continue;
    }
    kept.push_front(std::move(before[found - 1]));
    for (std::size_t j = found; j < before.size(); ++j) drop(std::move(before[j]), dropped);
    before.resize(found - 1);
  }
  for (Waiting& each : before) drop(std::move(each), dropped);
  waiting_ = std::move(kept);
}

void TimingRecorder::arrived(const Execution& execution, Clock::time_point time) {
  const services::MutexLock lock(mutex_);
  const std::size_t size = execution.waiting().size();
  const Moment now = moment_of(execution);
  JournalEntry newest = entry_at(execution, size - 1);
  if (waiting_.size() >= size) drop_older(newest, now);
  waiting_.push_back({std::move(newest), {time_of(time), now}});
  if (waiting_.size() != size) align(execution, now, now);
}

// A sample: only the newest waits.
void TimingRecorder::drop_older(const JournalEntry& newest, Moment from) {
  std::deque<Waiting> kept;
  for (Waiting& each : waiting_)
    if (is_same_event(each.input, newest))
      drop(std::move(each), from);
    else
      kept.push_back(std::move(each));
  waiting_ = std::move(kept);
}

// Responses before the first that still counts are passed over (execution::WaitingInputs::take).
std::optional<Arrival> TimingRecorder::take_first(const JournalEntry& entry, Moment dropped) {
  const bool is_there = std::ranges::any_of(waiting_, [&](const Waiting& each) { return is_same(each.input, entry); });
  while (is_there) {
    Waiting first = std::move(waiting_.front());
    waiting_.pop_front();
    if (is_same(first.input, entry)) return first.arrival;
    drop(std::move(first), dropped);
  }
  return std::nullopt;
}

void TimingRecorder::began(const Execution& execution, const std::optional<JournalEntry>& entry,
                           Clock::time_point time) {
  const services::MutexLock lock(mutex_);
  const std::uint64_t position = execution.run().position();
  StepTime step{time_of(time)};
  const Moment taken{position, 0};
  const bool is_input =
      entry && (std::holds_alternative<EventEntry>(*entry) || std::holds_alternative<ResponseEntry>(*entry));
  if (is_input) step.input = take_first(*entry, taken);
  if (waiting_.size() != execution.waiting().size() && !execution.is_over()) align(execution, taken, taken);
  if (is_input && !step.input) block_.since = std::max(block_.since, taken);
  if (block_.steps.empty()) block_.first = position;
  block_.steps.push_back(step);
}

bool TimingRecorder::has_begun(std::uint64_t position) const {
  const services::MutexLock lock(mutex_);
  return block_.last() >= position;
}

void TimingRecorder::ended(const Execution& execution) {
  const services::MutexLock lock(mutex_);
  drop_all({execution.run().position(), Moment::kEnd});
}

void TimingRecorder::rebuilt(const Execution& execution) {
  const services::MutexLock lock(mutex_);
  const std::uint64_t position = execution.run().position();
  written_.clear();  // it is in the store or lost
  block_.undelivered.clear();
  undelivered_units_ = 0;
  block_.steps.clear();
  block_.since = {position, Moment::kEnd};
  waiting_.clear();
  align(execution, block_.since, block_.since);
  block_.first = position + 1;
}

void TimingRecorder::use(const std::vector<ServiceChange>& services) {
  const services::MutexLock lock(mutex_);
  services_.clear();
  for (const ServiceChange& each : services) {
    services_[each.service] = each.state;
    block_.services.push_back({time_of(Clock::now()), each.service, each.state});
  }
}

bool TimingRecorder::service_changed(const std::string& service, const std::optional<std::string>& state) {
  const services::MutexLock lock(mutex_);
  const auto found = services_.find(service);
  if (found == services_.end() || found->second == state) return false;
  found->second = state;
  const ServiceChange change{time_of(Clock::now()), service, state};
  if (block_.services.size() < TimingBlock::kMostChanges) {
    block_.services.push_back(change);
    return true;
  }
  const auto last =
      std::ranges::find(block_.services.rbegin(), block_.services.rend(), service, &ServiceChange::service);
  if (last != block_.services.rend()) last->state = state;  // of too many, the last one stays
  return true;
}

bool TimingRecorder::has_news() const {
  const services::MutexLock lock(mutex_);
  return !block_.steps.empty() || !block_.undelivered.empty() || block_.services.size() > states_;
}

bool TimingRecorder::is_due() const {
  const services::MutexLock lock(mutex_);
  return block_.steps.size() >= kSteps || block_.services.size() >= states_ + kChanges ||
         time_of(Clock::now()) - block_.begins >= std::chrono::microseconds(kInterval).count();
}

// What has come since then, and waits, is in no block yet.
Moment TimingRecorder::earliest(Moment now) const {
  return waiting_.empty() ? now : std::min(now, waiting_.front().arrival.moment);
}

void TimingRecorder::begin_block() {
  TimingBlock next;
  next.first = block_.last() + 1;
  next.begins = next.ends = block_.ends;
  next.since = block_.since;
  for (const auto& [service, state] : services_) next.services.push_back({next.begins, service, state});
  states_ = next.services.size();
  undelivered_units_ = 0;
  block_ = std::move(next);
}

TimingBlock TimingRecorder::take_block(const Execution& execution, std::uint64_t ticket) {
  const services::MutexLock lock(mutex_);
  block_.ends = time_of(Clock::now());
  const std::uint64_t position = execution.run().position();
  block_.until = execution.is_over() ? Moment{position + 1, 0} : earliest(moment_of(execution));
  TimingBlock taken = block_;
  begin_block();
  written_.push_back({ticket, taken});
  return taken;
}

void TimingRecorder::durable(std::uint64_t ticket) {
  const services::MutexLock lock(mutex_);
  while (!written_.empty() && written_.front().ticket <= ticket) written_.pop_front();
}

std::vector<TimingBlock> TimingRecorder::blocks() const {
  const services::MutexLock lock(mutex_);
  std::vector<TimingBlock> blocks;
  for (const Written& each : written_) blocks.push_back(each.block);
  blocks.push_back(block_);
  blocks.back().ends = time_of(Clock::now());
  blocks.back().until = kNever;
  for (const Waiting& each : waiting_) blocks.back().undelivered.push_back({each.input, each.arrival, kNever});
  return blocks;
}

}  // namespace race::server
