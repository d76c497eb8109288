// Numbers of what code reads and names: places in Δ, events and operations of services.
#pragma once

#include <cstdint>

namespace race::language {

/// The index of the value of a parameter, result or variable in Δ.
using ValueIndex = std::uint32_t;
/// The index of `active` of a node or a port in Δ.
using Flag = std::uint32_t;
using EventId = std::uint32_t;
using OperationId = std::uint32_t;
inline constexpr std::uint32_t kNone = 0xffffffff;

}  // namespace race::language
