// The program `race`.
#include "server/commands/command.h"
#include "server/commands/table.h"

int main(int argc, char** argv) {
  return race::server::run_command(race::server::all_commands(), {argv + 1, argv + argc});
}
