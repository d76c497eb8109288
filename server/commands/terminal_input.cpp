#include "server/commands/terminal_input.h"

#include <termios.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>

namespace race::server {
namespace {

constexpr std::size_t kLongestLine = 1000;  // no name and no password is as long
constexpr std::array kEnding = {SIGINT, SIGTERM, SIGHUP, SIGQUIT};

// The terminal as it was: for the handler.
termios shown{};

// Whether the terminal shows what is typed, the end of a line too.
bool echoes() {
  termios now{};
  return ::tcgetattr(STDIN_FILENO, &now) == 0 && (now.c_lflag & static_cast<tcflag_t>(ECHO)) != 0;
}

// The signal comes again once this has returned, and ends the program.
void show_and_end(int signal) {
  ::tcsetattr(STDIN_FILENO, TCSAFLUSH, &shown);
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

}  // namespace

bool is_terminal_input() { return ::isatty(STDIN_FILENO) == 1; }

NoEcho::NoEcho() : is_terminal_(::tcgetattr(STDIN_FILENO, &shown) == 0) {
  if (!is_terminal_) return;
  for (std::size_t i = 0; i < kEnding.size(); ++i) {
    before_[i] = std::signal(kEnding[i], show_and_end);
    if (before_[i] == SIG_IGN) std::signal(kEnding[i], SIG_IGN);
  }
  termios silent = shown;
  silent.c_lflag &= ~static_cast<tcflag_t>(ECHO);
  ::tcsetattr(STDIN_FILENO, TCSAFLUSH, &silent);
}

NoEcho::~NoEcho() {
  if (!is_terminal_) return;
  ::tcsetattr(STDIN_FILENO, TCSAFLUSH, &shown);
  for (std::size_t i = 0; i < kEnding.size(); ++i) std::signal(kEnding[i], before_[i]);
}

Expected<std::string> read_input_line(const char* prompt, const std::string& what) {
  const bool is_terminal = is_terminal_input();
  if (is_terminal) std::fputs(prompt, stderr);
  std::string line;
  int next = std::getchar();
  const bool is_there = next != EOF;
  for (; next != EOF && next != '\n' && line.size() <= kLongestLine; next = std::getchar())
    line.push_back(static_cast<char>(next));
  if (is_terminal && !echoes()) std::fputs("\n", stderr);
  if (!is_there) return unexpected(ErrorCode::missing, "the standard input has no " + what, what);
  if (line.size() > kLongestLine)
    return unexpected(ErrorCode::missing, "the first line of the standard input is too long to be a " + what, what);
  return line;
}

}  // namespace race::server
