// Work: what an operation costs beyond the one unit of its syntax node, in units of the budget, by the sizes of what it
// reads and makes (core/SEMANTICS.md section 8, Budget). tests/bench/language/work_bench measures these rates.
#pragma once

#include <cstdint>

namespace race::language::work {

// Bytes of strings
/// that are copied, compared or hashed as a block,
constexpr std::uint64_t block(std::uint64_t bytes) { return bytes / 64; }
/// whose characters are counted,
constexpr std::uint64_t scan(std::uint64_t bytes) { return bytes / 16; }
/// in which something is sought,
constexpr std::uint64_t search(std::uint64_t bytes) { return bytes / 8; }
/// that are looked at character by character.
constexpr std::uint64_t characters(std::uint64_t bytes) { return bytes; }

/// Elements of lists that are visited, compared, moved or copied; values whose size is measured.
constexpr std::uint64_t elements(std::uint64_t count) { return count / 2; }
/// Entries of dicts that are copied,
constexpr std::uint64_t entries(std::uint64_t count) { return count; }
/// looked up one after the other,
constexpr std::uint64_t lookups(std::uint64_t count) { return 4 * count; }
/// or set.
constexpr std::uint64_t sets(std::uint64_t count) { return 8 * count; }
/// Strings, lists and dicts that are made.
constexpr std::uint64_t made(std::uint64_t count) { return 8 * count; }

}  // namespace race::language::work
