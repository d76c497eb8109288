// race man: the manual page race(1), made of the table of commands and what each declares.
#include <algorithm>
#include <array>
#include <cstdio>
#include <string>
#include <string_view>

#include "server/commands/table.h"
#include "server/wire/version.h"

namespace race::server {
namespace {

struct Escape {
  char letter;
  std::string_view text;
};

constexpr std::array kEscapes = {Escape{'\\', "\\e"},   Escape{'-', "\\-"},   Escape{'`', "\\(ga"},
                                 Escape{'\'', "\\(aq"}, Escape{'^', "\\(ha"}, Escape{'~', "\\(ti"}};

// A text for man(7): nothing of it is a request, and quotes stay what they are.
std::string escaped(std::string_view text) {
  std::string out = text.starts_with('.') ? "\\&" : "";
  for (const char c : text) {
    const auto known = std::ranges::find(kEscapes, c, &Escape::letter);
    out += known == kEscapes.end() ? std::string_view(&c, 1) : known->text;
  }
  return out;
}

std::string bold(std::string_view text) { return "\\fB" + escaped(text) + "\\fR"; }

// `race NAME`, what it does, its form, and its arguments.
std::string section_of(const Command& command) {
  Arguments arguments{std::string(command.name)};
  command.declare(arguments);
  std::string text =
      ".SS race " + escaped(command.name) + '\n' + escaped(command.text) + ".\n.PP\n" + bold(arguments.usage()) + '\n';
  for (const Arguments::Description& each : arguments.descriptions())
    text += ".TP\n" + bold(each.label) + '\n' + escaped(each.text) + '\n';
  return text;
}

constexpr const char* kBefore = R"(.SH NAME
race \- program, run and prove robot tasks
.SH SYNOPSIS
.B race
.I COMMAND
[\fIargument\fR ...]
.br
.B race
.I COMMAND
.B \-\-help
.SH DESCRIPTION
A task is a hierarchical state machine that coordinates stateful services: a robot, a gripper, a database.
.B race
runs and checks such tasks, serves them to browsers
.RB ( "race serve" ),
and asks a server that runs.
.PP
What is wrong is a line on the standard error, \fIFILE: path: code: message\fR; with \fB\-\-json\fR also JSON on the
standard output. As the name of a file, \fB\-\fR is the standard input, once in a command line.
.SH COMMANDS
)";

constexpr const char* kAfter = R"(.SH EXIT STATUS
.TP
.B 0
All is fine.
.TP
.B 1
The run or check found something, such as a fault, violations or damage; or a server refuses.
.TP
.B 2
Bad input: a command line that is wrong, a file that cannot be read or is no document, a document that cannot run, no
server; or there is not enough memory.
.SH ENVIRONMENT
.TP
.B RACE_TOKEN
The token of an account, for commands that ask a server, without \fB\-\-token\-file\fR.
.TP
.B RACE_CA
The authority that is trusted over https, without \fB\-\-ca\fR.
.TP
.B XDG_STATE_HOME
Where tokens are kept, instead of \fI\(ti/.local/state\fR.
.SH FILES
.TP
.I \(ti/.local/state/race/
The tokens that \fBrace login\fR keeps, each for one server.
.TP
.I .race\-pulled.json
Beside files that \fBrace pull\fR has written: of which revision each is a change. It is kept in git with them.
.TP
.I /etc/race/race.conf
The configuration of a server that systemd runs.
)";

int print() {
  std::string text = ".TH RACE 1 \"\" \"race " + std::string(version()) + "\" \"RACE\"\n" + kBefore;
  for (const Command* command : all_commands()) text += section_of(*command);
  std::fputs((text + kAfter).c_str(), stdout);
  return kExitOk;
}

std::function<int()> declare(Arguments&) { return print; }

}  // namespace

const Command kMan = {"man", "prints the manual page, for `race man | man -l -`", declare};

}  // namespace race::server
