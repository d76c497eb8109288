#include "core/rsm/rules.h"

#include <algorithm>
#include <iterator>

namespace race::rsm {
namespace {

bool defers_to(const Transition& x, const Transition& t) {
  return std::find(x.defer.begin(), x.defer.end(), t.id) != x.defer.end();
}

/// The conclusion that Trans1 and Trans2 share: cur = t.dst, and ε = t.respond ∪ t.events.
Effect take(const Service& service, Instance& instance, const Transition& t, std::uint64_t call) {
  instance.current = t.dst;
  return Effect{respond(service, instance, t, call), t.events};
}

/// Whether t answers one call that took x at a time (R25).
bool answers_one_of(const Transition& x, const Transition& t) { return x.concurrent && t.src && defers_to(x, t); }

/// The earliest call that t may answer, of those that it answers one at a time; 0: there is none.
std::uint64_t earliest(const Service& service, const Instance& instance, const Transition& t) {
  std::uint64_t found = 0;
  for (const Transition& x : service.transitions) {
    const auto pending = instance.pending.find(x.id);
    if (pending == instance.pending.end() || !answers_one_of(x, t)) continue;
    if (found == 0 || pending->second.front() < found) found = pending->second.front();
  }
  return found;
}

/// Removes and returns the calls that took x to which t responds; `one`: that which it answers if one at a time.
std::vector<std::uint64_t> responded(Instance& instance, const Transition& x, const Transition& t, std::uint64_t one) {
  const auto pending = instance.pending.find(x.id);
  if (pending == instance.pending.end()) return {};
  std::vector<std::uint64_t>& calls = pending->second;
  std::vector<std::uint64_t> out;
  if (!answers_one_of(x, t))
    out.swap(calls);
  else if (std::erase(calls, one) > 0)  // REFINEMENT R25
    out.push_back(one);
  if (calls.empty()) instance.pending.erase(pending);
  return out;
}

}  // namespace

Instance initial(const Service& service) { return Instance{service.init, {}}; }

const Transition* find_transition(const Service& service, std::string_view id) {
  const auto& all = service.transitions;
  const auto found = std::find_if(all.begin(), all.end(), [&](const Transition& t) { return t.id == id; });
  return found == all.end() ? nullptr : &*found;
}

bool leaves_current(const Transition& transition, const Instance& instance) {
  return !transition.src || *transition.src == instance.current;
}

const Transition* taken_on(const Service& service, const Instance& instance, std::string_view operation) {
  const auto& all = service.transitions;
  const auto found = std::find_if(all.begin(), all.end(), [&](const Transition& t) {
    return t.operation == operation && leaves_current(t, instance);
  });
  return found == all.end() ? nullptr : &*found;
}

// resolve(t) (4.2)
//
//              x | ∀x ∈ T                         if t.src = ∅
//   resolve =  x | ∀x ∈ T : t ∈ x.defer           if t.defer ≠ ∅
//              t ∪ x | ∀x ∈ T : t ∈ x.defer       else
std::vector<const Transition*> resolve(const Service& service, const Transition& t) {
  std::vector<const Transition*> out;
  for (const Transition& x : service.transitions) {
    const bool own = x.id == t.id && t.defer.empty();
    if (!t.src || own || defers_to(x, t)) out.push_back(&x);
  }
  return out;
}

// respond(t) (4.2)
//
//   respond = { x.operation | ∀x ∈ t.resolve : x.pending = true }
std::vector<Answer> respond(const Service& service, Instance& instance, const Transition& t, std::uint64_t call) {
  const std::uint64_t one = call != 0 ? call : earliest(service, instance, t);
  std::vector<Answer> out;
  for (const Transition* x : resolve(service, t)) {
    const bool is_error = t.error && x->id != t.id;
    for (const std::uint64_t answered : responded(instance, *x, t, one))
      out.push_back(Answer{answered, is_error, is_error ? *t.error : "", x->operation.value_or("")});
  }
  return out;
}

bool answers_one(const Service& service, const Instance& instance, const Transition& t, std::uint64_t call) {
  return std::ranges::any_of(service.transitions, [&](const Transition& x) {
    const auto pending = instance.pending.find(x.id);
    return answers_one_of(x, t) && pending != instance.pending.end() &&
           std::ranges::find(pending->second, call) != pending->second.end();
  });
}

void add_pending(Instance& instance, const Transition& t, std::uint64_t call) {
  std::vector<std::uint64_t>& calls = instance.pending[t.id];
  // REFINEMENT R17: the latest call that took t has the response; an earlier one has none any more.
  if (!t.concurrent) calls.clear();
  calls.push_back(call);
}

void drop_pending(Instance& instance, std::uint64_t call) {
  for (auto at = instance.pending.begin(); at != instance.pending.end();) {
    std::erase(at->second, call);
    at = at->second.empty() ? instance.pending.erase(at) : std::next(at);
  }
}

// Trans1 (4.4): a service takes a call.
//
//   ∃t ∈ svc.trans :   t.src = svc.cur ∪ ∅     α = t.operation     ω = channel(Ω, svc)
//   ε = t.respond ∪ t.events     put(Ω, ε) = Ω'[ε]
//   ───────────────────────────────────────────────────────────────
//   Ω ⊢ svc ↪[ω?α] svc'[cur = t.dst], Ω'[ε]
std::optional<Effect> Trans1(const Service& service, Instance& instance, std::string_view operation,
                             std::uint64_t call) {
  const Transition* t = taken_on(service, instance, operation);
  if (!t) return std::nullopt;
  add_pending(instance, *t, call);
  return take(service, instance, *t, 0);
}

// Trans2 (4.5): a service changes its state by itself, such as when a motion is done.
//
//   ∃t ∈ svc.trans :   t.src = svc.cur ∪ ∅     t.operation = ∅
//   ε = t.respond ∪ t.events     put(Ω, ε) = Ω'[ε]
//   ───────────────────────────────────────────────────────────────
//   Ω ⊢ svc ↪ svc'[cur = t.dst], Ω'[ε]
std::optional<Effect> Trans2(const Service& service, Instance& instance, std::string_view id, std::uint64_t call) {
  const Transition* t = find_transition(service, id);
  if (!t || t->operation || !leaves_current(*t, instance)) return std::nullopt;
  if (call != 0 && !answers_one(service, instance, *t, call)) return std::nullopt;
  return take(service, instance, *t, call);
}

// Stutter (4.6): a service stays in its state and puts that state's events.
//
//   ε = svc.cur.events     put(Ω, ε) = Ω'[ε]
//   ─────────────────────────────────────────
//   Ω ⊢ svc ↪ svc, Ω'[ε]
Effect Stutter(const Service& service, const Instance& instance) {
  for (const ServiceState& state : service.states) {
    if (state.name == instance.current) return Effect{{}, state.events};
  }
  return Effect{};
}

}  // namespace race::rsm
