// What a service says to who runs it.
#pragma once

#include <string>

namespace race::client {

/// Writes a text to stderr, as a line or several. Control characters, but for ends of lines, are blanks. On any thread.
void say(std::string text);

}  // namespace race::client
