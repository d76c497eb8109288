// The RSM of a declaration whose operations say in which states the service is meanwhile. Pure.
#pragma once

#include "api/cpp/race_client/declaration.h"
#include "core/rsm/model.h"

namespace race::client {

/// The first state, and the one in which nothing is busy.
inline constexpr const char* kReady = "Ready";

/// An operation that is busy leads from kReady to its state, and back when it is done. Every other is taken in each
/// state, and answered by itself; one that stops leads back to kReady. Each event may come in each state. The same as
/// of a class in api/python.
rsm::Service generated_rsm(const Declaration& declaration);

}  // namespace race::client
