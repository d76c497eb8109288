#include "server/model_tests/mock.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace race::server {

using services::Call;
using services::CallId;
using services::Time;

namespace {

constexpr Time kAnswerAfter = 0.1;  // s, of what a seed chooses
constexpr Time kSoon = 0.01;        // s: how much earlier than listed a transition may put an event
constexpr Time kTolerance = 5e-7;   // sums of millisecond steps do not hit a time exactly
constexpr double kSampleRate = 10;  // Hz, of an event that declares none

bool fits(const MockAnswer& listed, const AllowedAnswer& way, const rsm::Operation& operation) {
  if (way.is_error) return listed.is_error && listed.data.find("code")->as_string() == way.error_code;
  return !listed.is_error || !operation.error.is_null();
}

}  // namespace

bool is_error_of_cell(std::string_view code) {
  static constexpr std::array<std::string_view, 4> codes = {"unavailable", "not_accepted", "stopped", "leased"};
  return std::ranges::find(codes, code) != codes.end();
}

Mock::Mock(rsm::Service model, MockScript script, std::uint64_t seed, std::vector<std::string>& problems,
           services::ServiceHost& host)
    : model_(std::move(model)),
      script_(std::move(script)),
      random_(seed),
      problems_(problems),
      host_(host),
      instance_(rsm::initial(model_)) {}

void Mock::call(const Call& call) {
  OpenCall open{call.operation, next_answer(call.operation)};
  open.due = host_.now() + (open.listed ? open.listed->after : kAnswerAfter);
  if (open.listed && open.listed->never) open.due = std::numeric_limits<Time>::infinity();
  open.by_cell = open.listed && open.listed->is_error && is_error_of_cell(open.listed->data.find("code")->as_string());
  if (open.by_cell) {
    open_.insert_or_assign(call.id, std::move(open));
    return;
  }
  const rsm::Transition* taken = rsm::taken_on(model_, instance_, call.operation);
  if (!taken) return host_.reject(call.id);
  host_.transition(taken->id, call.id);
  open.defer = taken->defer;
  open_.insert_or_assign(call.id, std::move(open));
  if (const auto effect = rsm::Trans1(model_, instance_, call.operation, call.id)) put(*effect, call.id);
}

void Mock::step() {
  const Time now = host_.now();
  while (next_event_ < script_.events.size() && script_.events[next_event_].at <= now + kTolerance) {
    const std::size_t number = next_event_++;
    if (!put_.contains(number)) put_listed(script_.events[number]);
  }
  put_samples(now);
  std::vector<CallId> due;
  for (const auto& [call, open] : open_)
    if (open.due <= now + kTolerance) due.push_back(call);
  for (const CallId call : due) answer_due(call);
}

// The next of the operation that is not used; one that repeats stays.
std::optional<MockAnswer> Mock::next_answer(const std::string& operation) {
  for (std::size_t i = 0; i < script_.answers.size(); ++i) {
    const MockAnswer& answer = script_.answers[i];
    if (answer.operation != operation || used_.contains(i)) continue;
    if (!answer.repeat) used_.insert(i);
    return answer;
  }
  return {};
}

void Mock::answer_due(CallId call) {
  const auto found = open_.find(call);
  if (found == open_.end()) return;  // another answer was one to it, too
  OpenCall& open = found->second;
  if (open.by_cell) {
    host_.error(call, open.listed->data);
    open_.erase(found);
    return;
  }
  if (open.resolved) {
    const rsm::Answer answer = *open.resolved;
    pass_on(open);
    return respond(answer);
  }
  if (!is_pending(instance_, call)) {  // R17: a later call has taken the response
    open_.erase(found);
    return;
  }
  auto ways = allowed_answers(model_, instance_, call);
  if (ways.empty()) return;  // it waits for a call of another operation
  if (open.listed) {
    const rsm::Operation& called = operation(open.operation);
    std::erase_if(ways, [&](const AllowedAnswer& way) { return !fits(*open.listed, way, called); });
    std::ranges::stable_partition(ways, &AllowedAnswer::is_error);  // an error of the RSM rather than one of a result
    if (ways.empty() && !std::exchange(open.was_refused, true))
      problems_.push_back("the answer that is listed for `" + open.operation +
                          "` is none that the RSM allows in the state `" + instance_.current + "`");
    if (ways.empty()) return;
    return take(ways.front(), call);
  }
  take(ways[random_() % ways.size()], call);
}

// What takes a call in every state answers it (resolve of 4.2), also if it leads to a state that only passes, such as
// that of a camera that starts: what it defers to leads on.
void Mock::pass_on(const OpenCall& open) {
  std::vector<std::string> next;
  for (const std::string& id : open.defer) {
    const rsm::Transition* transition = rsm::find_transition(model_, id);
    if (transition && !transition->operation && rsm::leaves_current(*transition, instance_)) next.push_back(id);
  }
  if (next.empty()) return;
  const std::size_t of_listed = open.listed && open.listed->is_error ? next.size() - 1 : 0;
  take({{next[open.listed ? of_listed : random_() % next.size()]}, false, ""}, 0);
}

void Mock::take(const AllowedAnswer& way, CallId call) {
  for (const std::string& id : way.transitions) {
    const rsm::Transition& transition = *rsm::find_transition(model_, id);
    const CallId answered = rsm::answers_one(model_, instance_, transition, call) ? call : 0;
    host_.transition(id, answered);
    if (const auto effect = rsm::Trans2(model_, instance_, id, answered)) put(*effect);
  }
}

// `kept`: a call whose response is to wait until it is due.
void Mock::put(const rsm::Effect& effect, CallId kept) {
  for (const rsm::Answer& answer : effect.answers) {
    const auto open = open_.find(answer.call);
    if (answer.call == kept && open != open_.end())
      open->second.resolved = answer;
    else
      respond(answer);
  }
  for (const std::string& event : effect.events) host_.event(event, event_data(event));
}

void Mock::respond(const rsm::Answer& answer) {
  const auto found = open_.find(answer.call);
  if (found == open_.end()) return;
  const OpenCall open = std::move(found->second);
  open_.erase(found);
  const rsm::Operation& called = operation(open.operation);
  const bool lists = open.listed && !open.listed->never;
  if (answer.is_error) {
    const bool same =
        lists && open.listed->is_error && open.listed->data.find("code")->as_string() == answer.error_code;
    return host_.error(answer.call, same ? open.listed->data : any_error(called.error, answer.error_code, random_));
  }
  if (lists) {
    if (open.listed->is_error) return host_.error(answer.call, open.listed->data);
    return host_.result(answer.call, open.listed->data);
  }
  if (!called.error.is_null() && random_() % 2 == 0)
    return host_.error(answer.call, any_error(called.error, "", random_));
  host_.result(answer.call, any_value(called.result, random_));
}

// As the state puts it, or by a spontaneous transition that does; what that answers comes after it.
void Mock::put_listed(const MockEvent& event) {
  const auto events = rsm::Stutter(model_, instance_).events;
  if (std::ranges::find(events, event.event) != events.end()) return host_.event(event.event, event.data);
  for (const rsm::Transition& t : model_.transitions) {
    if (t.operation || !rsm::leaves_current(t, instance_)) continue;
    if (std::ranges::find(t.events, event.event) == t.events.end()) continue;
    const auto effect = rsm::Trans2(model_, instance_, t.id);
    if (!effect) continue;
    host_.transition(t.id);
    for (const std::string& each : effect->events)
      host_.event(each, each == event.event ? event.data : event_data(each));
    for (const rsm::Answer& answer : effect->answers) respond(answer);
    return;
  }
  problems_.push_back("the event `" + event.event + "` is none that the RSM allows in the state `" + instance_.current +
                      "`");
}

void Mock::put_samples(Time now) {
  for (const std::string& event : rsm::Stutter(model_, instance_).events) {
    const Value* data = script_.samples.find(event);
    if (!data) continue;
    Time& next = next_sample_[event];
    if (next > now + kTolerance) continue;
    const auto declared = std::ranges::find(model_.events, event, &rsm::Event::name);
    const double rate = declared == model_.events.end() ? kSampleRate : declared->rate_hz.value_or(kSampleRate);
    next = now + 1 / (rate > 0 ? rate : kSampleRate);
    host_.event(event, *data);
  }
}

// Of an event that a transition puts: it may be one that is listed.
Value Mock::event_data(const std::string& event) {
  const std::vector<MockEvent>& listed_events = script_.events;
  for (std::size_t i = next_event_; i < listed_events.size() && listed_events[i].at <= host_.now() + kSoon; ++i)
    if (listed_events[i].event == event && put_.insert(i).second) return listed_events[i].data;
  if (const Value* listed = script_.samples.find(event)) return *listed;
  const auto declared = std::ranges::find(model_.events, event, &rsm::Event::name);
  return declared == model_.events.end() ? Value() : any_value(declared->data, random_);
}

// Requires that there is one, as of every call that the host delivers.
const rsm::Operation& Mock::operation(std::string_view name) const {
  return *std::ranges::find(model_.operations, name, &rsm::Operation::name);
}

}  // namespace race::server
