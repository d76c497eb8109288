// What a core is after a delta (api/schemas/core_state.json, core_delta.json). Pure.
#pragma once

#include <optional>
#include <string_view>

#include "core/value/value.h"

namespace race::client {

/// Whether a run with this status is over for good.
bool is_over(std::string_view status);

/// The status in a core_state.json or core_delta.json; empty if it has none.
std::string_view status_of(const Value& state);

/// The state after a delta; nothing, if one of them is none. Lists are in the order in which their elements became
/// active; an order of the model is not kept.
std::optional<Value> fold(const Value& before, const Value& delta);

/// Whether it has what fold() needs of a state.
bool is_state(const Value& state);

}  // namespace race::client
