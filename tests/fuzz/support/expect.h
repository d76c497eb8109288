// What must hold whatever the input is: FUZZ_EXPECT(condition) ends the program if it does not, which libFuzzer reports
// with the input.
#pragma once

#include <cstdio>
#include <cstdlib>

namespace race::fuzz {

[[noreturn]] inline void fail(const char* what, const char* file, int line) {
  std::fprintf(stderr, "%s:%d: does not hold: %s\n", file, line, what);
  std::abort();
}

}  // namespace race::fuzz

#define FUZZ_EXPECT(condition) \
  (static_cast<bool>(condition) ? void() : ::race::fuzz::fail(#condition, __FILE__, __LINE__))
