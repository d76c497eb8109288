// How tests with random or with many cases are set from the environment.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>

namespace race {

/// A number from the environment, such as RACE_SEED.
inline std::uint64_t setting(const char* name, std::uint64_t otherwise) {
  const char* text = std::getenv(name);
  return text ? std::strtoull(text, nullptr, 10) : otherwise;
}

/// How many of `cases` a test takes: one in RACE_SAMPLE, at least one. Builds with sanitizers take a sample.
inline std::size_t sample(std::size_t cases) {
  const std::size_t one_in = setting("RACE_SAMPLE", 1);
  return one_in > 1 ? (cases + one_in - 1) / one_in : cases;
}

}  // namespace race
