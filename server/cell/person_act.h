// What a person at the cell does, as clients and operator scripts say it (schemas/person_act.json).
#pragma once

#include <string>
#include <variant>

#include "core/value/fields.h"
#include "services/world/person.h"

namespace race::server {

struct GrabAct {
  std::string hand;
  world::Hold hold;
};
struct DragAct {
  std::string hand;
  world::Drag drag;
  bool relative = false;  // the path counts from where the target is
};
struct ReleaseAct {
  std::string hand;
};
struct PlaceAct {
  std::string part;
  std::optional<world::Pose> o_t_part;
};
struct TakeAct {
  std::string part;
};

struct PersonAct {
  std::variant<GrabAct, DragAct, ReleaseAct, world::Push, PlaceAct, TakeAct> what;
  double keep = 0;  // s, of a hand: Person::keep()
};

/// Characters of a hand's name, which has one at least.
inline constexpr std::size_t kHandName = 64;

/// Seconds that a client's hand stays without a word when the act does not say it.
inline constexpr double kClientPatience = 0.5;

/// Reads the fields of an act; violations go to the fields' list. `keep`: what an act without that field has. The
/// caller closes the fields.
PersonAct read_person_act(Fields& fields, double keep);
/// Reads a whole act; lists all violations.
Checked<PersonAct> read_person_act(const Value& json, double keep);

/// What reads back as the same act with a `keep` of infinity where the act has none. Requires finite numbers but
/// `keep`.
Value write_person_act(const PersonAct& act);

/// Does it; on the thread of the world. Errors: those of Person, with the field as path.
Expected<void> perform(const PersonAct& act, world::Person& person);

}  // namespace race::server
