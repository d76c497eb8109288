#include "server/commands/watching.h"

#include <unistd.h>

#include <csignal>
#include <cstdio>

namespace race::server {
namespace {

// What a handler may use: set before it is there.
int exit_code = 0;
const char* farewell_text = "";
std::size_t farewell_size = 0;

void end_now(int) {
  // What cannot be said is not said.
  if (::write(STDERR_FILENO, farewell_text, farewell_size) < 0) ::_exit(exit_code);
  ::_exit(exit_code);
}

}  // namespace

void end_on_signal(int code, const std::string& farewell) {
  static std::string text;
  text = farewell;
  farewell_text = text.c_str();
  farewell_size = text.size();
  exit_code = code;
  std::fflush(stdout);
  std::setvbuf(stdout, nullptr, _IOLBF, 0);  // also into a pipe
  struct sigaction action {};
  action.sa_handler = end_now;
  for (const int signal : {SIGINT, SIGTERM}) ::sigaction(signal, &action, nullptr);
}

}  // namespace race::server
