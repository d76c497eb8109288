#include "server/cell/operator.h"

#include <algorithm>
#include <limits>

namespace race::server {
namespace {

/// Half a step: sums of steps are not exact.
constexpr double kSlack = world::World::kStep / 2;

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

bool has_button(const std::vector<std::string>& buttons, const std::string& button) {
  return button.empty() || std::ranges::find(buttons, button) != buttons.end();
}

/// What names a thing that is shown, so that it is not taken for a new one at the next look; empty: it does not fit.
std::string fitting(const OnDisplay& on, const display::Content& content) {
  if (const auto& question = content.question;
      question && contains(question->text, on.text) && has_button(question->buttons, on.button))
    return "question " + std::to_string(question->id);
  if (const auto& message = content.message;
      message && contains(message->text, on.text) && has_button(message->buttons, on.button))
    return "message " + message->text;
  return "";
}

std::set<std::string> nodes_of(const OperatorScript& script) {
  std::set<std::string> nodes;
  for (const ScriptedAct& act : script.acts)
    if (const auto* state = std::get_if<OnState>(&act.when.what)) nodes.insert(state->path);
  return nodes;
}

}  // namespace

Operator::Operator(OperatorScript script, display::Screens& screens, Log log)
    : script_(std::move(script)), screens_(screens), log_(std::move(log)), named_(nodes_of(script_)) {
  for (const auto& [name, place] : script_.displays) {
    if (displays_.contains(name)) continue;
    if (auto connection = screens_.connect(name, true, place)) {
      displays_.emplace(name, *connection);
    } else {
      log_("stands before no display `" + name + "`: " + connection.error().message);
    }
  }
}

Operator::~Operator() {
  for (const auto& [name, connection] : displays_) screens_.disconnect(connection);
}

void Operator::begin() {
  const services::MutexLock lock(mutex_);
  begins_ = true;
}

void Operator::note(const std::function<bool(const When&)>& fits) {
  for (Waiting& waiting : waiting_)
    if (!waiting.met && fits(script_.acts[waiting.act].when)) ++waiting.seen;
}

void Operator::set_active(const std::string& core, const std::string& path, bool on) {
  if (!named_.contains(path)) return;
  if (on) {
    if (!active_[core].insert(path).second) return;
  } else {
    const auto known = active_.find(core);
    if (known == active_.end() || known->second.erase(path) == 0) return;
    if (known->second.empty()) active_.erase(known);
    left_.insert(path);
  }
  note([&](const When& when) {
    const auto* state = std::get_if<OnState>(&when.what);
    return state && state->path == path && state->active == on;
  });
}

void Operator::changed(const std::string& core, const Dict& active, const List& fired) {
  const services::MutexLock lock(mutex_);
  for (const auto& [path, on] : active) set_active(core, path.as_string(), on.as_bool());
  for (const Value& port : fired)
    note([&](const When& when) {
      const auto* on = std::get_if<OnPort>(&when.what);
      return on && on->port == port.as_string();
    });
}

void Operator::state(const std::string& core, const List& active) {
  const services::MutexLock lock(mutex_);
  std::set<std::string> now;
  for (const Value& path : active) now.insert(path.as_string());
  const auto known = active_.find(core);
  const std::set<std::string> before = known == active_.end() ? std::set<std::string>() : known->second;
  for (const std::string& path : before)
    if (!now.contains(path)) set_active(core, path, false);
  for (const std::string& path : now) set_active(core, path, true);
}

void Operator::removed(const std::string& core) {
  const services::MutexLock lock(mutex_);
  active_.erase(core);
}

std::size_t Operator::remembered() const {
  const services::MutexLock lock(mutex_);
  std::size_t nodes = left_.size();
  for (const auto& [core, paths] : active_) nodes += paths.size();
  return nodes;
}

void Operator::happened(const services::Delivery& event) {
  if (event.kind != services::Delivery::Kind::event) return;
  const services::MutexLock lock(mutex_);
  note([&](const When& when) {
    const auto* on = std::get_if<OnEvent>(&when.what);
    if (!on || on->service != event.key || on->event != event.name) return false;
    return std::ranges::all_of(on->data, [&](const auto& field) {
      const Value* value = event.data.find(field.first.as_string());
      return value && *value == field.second;
    });
  });
}

// What is so already counts the first time, but not for an act that was just done because of it.
Operator::Waiting Operator::wait_for(std::size_t act, services::Time now, bool anew) const {
  Waiting waiting{act, now};
  const auto* state = std::get_if<OnState>(&script_.acts[act].when.what);
  if (!state || anew) return waiting;
  const bool active = std::ranges::any_of(active_, [&](const auto& core) { return core.second.contains(state->path); });
  if (active == state->active && (active || left_.contains(state->path))) waiting.seen = 1;
  return waiting;
}

// The sequence goes on with the act after the one that waits last.
void Operator::next(services::Time now) {
  std::size_t act = 0;
  if (!waiting_.empty() && !script_.acts[waiting_.back().act].always) {
    act = waiting_.back().act + 1;
    waiting_.pop_back();
  }
  while (act < script_.acts.size() && script_.acts[act].always) ++act;
  if (act < script_.acts.size()) waiting_.push_back(wait_for(act, now, false));
}

void Operator::look() {
  for (const auto& [name, connection] : displays_) {
    const auto content = screens_.content(name);
    if (!content) continue;
    for (Waiting& waiting : waiting_) look(waiting, *content);
  }
}

void Operator::look(Waiting& waiting, const display::Content& content) {
  const auto* on = std::get_if<OnDisplay>(&script_.acts[waiting.act].when.what);
  if (!on || waiting.met || (!on->display.empty() && on->display != content.display)) return;
  const std::string shown = fitting(*on, content);
  if (shown.empty() || (shown == waiting.shown && content.display == waiting.display)) return;
  waiting.shown = shown;
  waiting.display = content.display;
  ++waiting.seen;
}

void Operator::hear(services::Time now) {
  for (const auto& [name, connection] : displays_) {
    const auto content = screens_.content(name);
    if (!content || !content->sound) {
      sounds_.erase(name);
      continue;
    }
    auto& heard = sounds_.try_emplace(name, Heard{now, content->sound->id}).first->second;
    if (heard.sound != content->sound->id) heard = {now, content->sound->id};
    if (now - heard.since < kSoundDuration) continue;
    (void)screens_.played(connection, heard.sound);  // it may have been silenced meanwhile
    heard.since = std::numeric_limits<double>::infinity();
  }
}

bool Operator::due(Waiting& waiting, services::Time now) const {
  const When& when = script_.acts[waiting.act].when;
  if (const auto* time = std::get_if<OnTime>(&when.what)) {
    waiting.met = time->absolute ? start_ : waiting.since;
  } else if (!waiting.met && waiting.seen >= when.count) {
    waiting.met = now;
  }
  return waiting.met && now - *waiting.met >= when.after - kSlack;
}

void Operator::step(services::Time now, CellWorld& world) {
  const services::MutexLock lock(mutex_);
  if (std::exchange(begins_, false)) {
    running_ = true;
    start_ = now;
    looked_ = now - kDisplayPeriod;
    waiting_.clear();
    for (std::size_t i = 0; i < script_.acts.size(); ++i)
      if (script_.acts[i].always) waiting_.push_back(wait_for(i, now, false));
    next(now);
  }
  if (!running_) return;
  if (!displays_.empty() && now - looked_ >= kDisplayPeriod - kSlack) {
    looked_ = now;
    look();
    hear(now);
  }
  for (Waiting& waiting : waiting_) {
    if (!script_.acts[waiting.act].always || !due(waiting, now)) continue;
    act(waiting, world);
    Waiting again = wait_for(waiting.act, now, true);
    again.display = waiting.display;
    again.shown = waiting.shown;
    waiting = std::move(again);
  }
  // Acts that wait for nothing more are done in the same step.
  while (!waiting_.empty() && !script_.acts[waiting_.back().act].always && due(waiting_.back(), now)) {
    act(waiting_.back(), world);
    next(now);
  }
}

void Operator::act(const Waiting& waiting, CellWorld& world) {
  const ScriptedAct& scripted = script_.acts[waiting.act];
  const std::string name = "acts/" + std::to_string(waiting.act) + (scripted.doc.empty() ? "" : ": " + scripted.doc);
  log_(name);
  for (const auto& each : scripted.acts) {
    if (const auto* by_display = std::get_if<AnswerCommand>(&each)) {
      answer(*by_display, waiting);
      continue;
    }
    const auto wanted = [] { return true; };
    world.execute(std::get<PersonCommand>(each), wanted, [log = log_, name](const Expected<Value>& done) {
      if (!done) log(name + ": refused: " + to_string(done.error()));
    });
  }
}

void Operator::answer(const AnswerCommand& act, const Waiting& waiting) {
  std::string name = act.display.empty() ? waiting.display : act.display;
  if (name.empty() && !script_.displays.empty()) name = script_.displays.front().name;
  const auto content = screens_.content(name);
  const bool press = content && !content->question && act.answer.is_string();
  const auto done = press ? screens_.press(name, act.answer.as_string()) : screens_.answer(name, act.answer);
  if (!done) log_("display `" + name + "`: refused: " + to_string(done.error()));
}

}  // namespace race::server
