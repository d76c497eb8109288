#include "server/log/event_log.h"

#include <iterator>
#include <utility>

#include "core/language/primitives/utf8.h"
#include "server/wire/channel_names.h"

namespace race::server {
namespace {

std::string text_of(const Value& json, const char* name) {
  const Value* field = json.find(name);
  return field ? field->as_string() : std::string();
}

std::string status_line(const Value& core) {
  std::string line = text_of(core, "document") + ": " + text_of(core, "status");
  if (const std::string outcome = text_of(core, "outcome"); !outcome.empty()) line += " at " + outcome;
  if (const Value* fault = core.find("fault"))
    line += ", " + text_of(*fault, "kind") + " at " + text_of(*fault, "at") + ": " + text_of(*fault, "message");
  if (const Value* interruption = core.find("interruption")) line += ": " + text_of(*interruption, "message");
  return line;
}

LogLevel level_of(std::string_view status) {
  if (status == "faulted") return LogLevel::error;
  return status == "interrupted" ? LogLevel::warning : LogLevel::info;
}

}  // namespace

void EventLog::append(services::Time time, const std::string& source, const std::string& text, LogLevel level) {
  ++counts_.at(static_cast<std::size_t>(level));
  if (lines_) lines_->write(level, source, text);
  const std::string valid = as_utf8(text);
  Value entry =
      Dict{{"time", time}, {"source", as_utf8(source)}, {"text", std::string(language::utf8::prefix(valid, kMaxText))}};
  entry.freeze();
  {
    const services::MutexLock lock(mutex_);
    entries_.push_back(entry);
    if (entries_.size() > kMaxEntries) entries_.pop_front();
  }
  Value delta = Dict{{"entries", List{entry}}};
  hub_.publish_delta(std::string(kLogChannel), std::move(delta.freeze()));
}

bool EventLog::append_status(services::Time time, const std::string& core_id, const Value& core) {
  const std::string status = text_of(core, "status");
  {
    const services::MutexLock lock(mutex_);
    std::string& last = statuses_[core_id];
    if (std::exchange(last, status) == status) return false;
    if (statuses_.size() > kMaxStatuses)  // of cores that reported after they had been removed
      statuses_.erase(statuses_.begin()->first == core_id ? std::next(statuses_.begin()) : statuses_.begin());
  }
  append(time, "core/" + core_id, status_line(core), level_of(status));
  return true;
}

void EventLog::drop_status(const std::string& core_id) {
  const services::MutexLock lock(mutex_);
  statuses_.erase(core_id);
}

void EventLog::publish_snapshot() const {
  List entries;
  {
    const services::MutexLock lock(mutex_);
    entries.assign(entries_.begin(), entries_.end());
  }
  Value snapshot = Dict{{"entries", std::move(entries)}};
  hub_.publish_snapshot(std::string(kLogChannel), std::move(snapshot.freeze()));
}

}  // namespace race::server
