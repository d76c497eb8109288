// What a person at the cell does, as clients and operator scripts say it (schemas/person_command.json).
#pragma once

#include <string>
#include <variant>

#include "core/value/fields.h"
#include "services/world/person.h"

namespace race::server {

struct GrabCommand {
  std::string hand;
  world::Hold hold;
};
struct DragCommand {
  std::string hand;
  world::Drag drag;
  bool relative = false;  // the path counts from where the target is
};
struct ReleaseCommand {
  std::string hand;
};
struct PlaceCommand {
  std::string part;
  std::optional<world::Pose> o_t_part;
};
struct TakeCommand {
  std::string part;
};

struct PersonCommand {
  std::variant<GrabCommand, DragCommand, ReleaseCommand, world::Push, PlaceCommand, TakeCommand> what;
  double keep = 0;  // s, of a hand: Person::keep()
};

/// Characters of a hand's name, which has one at least.
inline constexpr std::size_t kHandName = 64;

/// Seconds that a client's hand holds on without a further command, if its command has no `keep`.
inline constexpr double kClientKeep = 0.5;

/// Reads the fields of a command; violations go to the fields' list. `keep`: the value if that field is absent. The
/// caller closes the fields.
PersonCommand read_person_command(Fields& fields, double keep);
/// Reads a whole command; lists all violations.
Checked<PersonCommand> read_person_command(const Value& json, double keep);

/// Reads back as the same command with infinity as default of `keep`. Requires finite numbers except for `keep`.
Value write_person_command(const PersonCommand& command);

/// Executes the command on the thread of the world. Errors: those of Person, with the field as path.
Expected<void> perform(const PersonCommand& command, world::Person& person);

}  // namespace race::server
