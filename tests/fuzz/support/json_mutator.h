// Mutations that keep a text JSON: bytes that are changed at random are seldom JSON, and never get past its parser.
#pragma once

#include <cstddef>
#include <cstdint>

namespace race::fuzz {

/// Changes one place of the JSON in `data`, or its bytes (always if it is no JSON); at most `most` bytes. The new size.
/// What LLVMFuzzerCustomMutator does.
std::size_t mutate_json(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed);

/// The same for lines of JSON: changes one of them, or their bytes.
std::size_t mutate_json_lines(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed);

}  // namespace race::fuzz

/// libFuzzer finds the mutator of a target by its name.
#define FUZZ_MUTATE_WITH(function)                                                                       \
  extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most, \
                                                 unsigned seed) {                                        \
    return function(data, size, most, seed);                                                             \
  }
