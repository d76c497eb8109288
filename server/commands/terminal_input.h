// What a person types, or another program sends: lines of the standard input, and passwords, which no terminal shows.
//
// Threads: one.
#pragma once

#include <array>
#include <string>

#include "core/value/expected.h"

namespace race::server {

/// Whether a person types: the standard input is a terminal.
bool is_terminal_input();

/// A terminal shows nothing of what is typed while this lives; a signal that ends the program meanwhile (Ctrl-C) lets
/// it show again. One at a time.
class NoEcho {
 public:
  NoEcho();
  ~NoEcho();
  NoEcho(const NoEcho&) = delete;
  NoEcho& operator=(const NoEcho&) = delete;

 private:
  const bool is_terminal_;
  std::array<void (*)(int), 4> before_{};  // who handled the signals
};

/// The next line, without its end; a terminal shows `prompt` first. Error `missing`, with `what` (such as "password")
/// as path: there is none, or it has more than 1000 bytes.
Expected<std::string> read_input_line(const char* prompt, const std::string& what);

}  // namespace race::server
