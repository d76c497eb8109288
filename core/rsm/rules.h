// The rules of RSM (thesis 4.3.2): Trans1, Trans2 and Stutter, on an Instance, the semantic state of one service. A
// rule changes the instance and returns what it puts into the environment; nothing, and no change, if it does not
// apply. Pure; an Instance is a value.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/rsm/model.h"

namespace race::rsm {

/// cur(svc), and pending(t) of each transition that has a response to give: with the call that it is for.
struct Instance {
  std::string current;
  std::map<std::string, std::vector<std::uint64_t>> pending;  // calls by id of the transition, in order; one, unless
                                                              // it is concurrent
  bool operator==(const Instance&) const = default;
};

/// A service in its initial state, with nothing pending.
Instance initial(const Service& service);

/// One response: to which call, of which operation, and whether it is an error with `error_code` or a result.
struct Answer {
  std::uint64_t call = 0;
  bool is_error = false;
  std::string error_code;
  std::string operation;
  bool operator==(const Answer&) const = default;
};

/// ε: what a rule puts into the environment, the responses first.
struct Effect {
  std::vector<Answer> answers;
  std::vector<std::string> events;
  bool operator==(const Effect&) const = default;
};

/// The transition `id`; nullptr if there is none.
const Transition* find_transition(const Service& service, std::string_view id);

/// Whether `transition` starts in the current state or in every state.
bool leaves_current(const Transition& transition, const Instance& instance);

/// The first transition, as declared, that the current state takes on a call of `operation`; nullptr if there is none.
const Transition* taken_on(const Service& service, const Instance& instance, std::string_view operation);

/// resolve(t) of 4.2, in order of declaration.
std::vector<const Transition*> resolve(const Service& service, const Transition& t);

/// respond(t) of 4.2: the pending responses of resolve(t), which are no longer pending. R17: each goes to the latest
/// call that took the deferring transition. R25: of all calls of concurrent transitions that defer to t, which has
/// a source, `call` alone is answered, 0: the earliest. Where t declares an error, the deferred ones are that error;
/// t's own is a result.
std::vector<Answer> respond(const Service& service, Instance& instance, const Transition& t, std::uint64_t call = 0);

/// pending(t) := true (4.2): `call` has taken t.
void add_pending(Instance& instance, const Transition& t, std::uint64_t call);

/// `call` has had its response by other ways than a transition that answers it: no transition is to answer it any more.
void drop_pending(Instance& instance, std::uint64_t call);

/// Whether `call` has taken a concurrent transition that defers to t, and has no response yet (R25).
bool answers_one(const Service& service, const Instance& instance, const Transition& t, std::uint64_t call);

/// A call of `operation`, numbered `call`. Nothing: no transition of the current state takes it (R7: not accepted).
std::optional<Effect> Trans1(const Service& service, Instance& instance, std::string_view operation,
                             std::uint64_t call);

/// The spontaneous transition `id`, which answers `call` if there are several that it may answer (R25). Nothing: there
/// is none, it waits for a call, does not leave the current state, or does not answer this call.
std::optional<Effect> Trans2(const Service& service, Instance& instance, std::string_view id, std::uint64_t call = 0);

/// The events of the current state; the instance stays as it is.
Effect Stutter(const Service& service, const Instance& instance);

}  // namespace race::rsm
