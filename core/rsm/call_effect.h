// What a call of an operation may do in a cell, as the declaration of the operation says.
#pragma once

#include <cstdint>

#include "core/rsm/model.h"

namespace race::rsm {

/// Each may what those before it may.
enum class CallEffect : std::uint8_t {
  none,    // it reads (`reads`)
  stop,    // only stops what is in motion (`safe`)
  change,  // changes something that a run may read or ask next
  pace,    // changes how fast what is in motion already goes on (`paces`)
  motion,  // sets something in motion (`moves`)
};

inline CallEffect effect_of(const Operation& operation) {
  if (operation.moves) return operation.paces ? CallEffect::pace : CallEffect::motion;
  if (operation.safe) return CallEffect::stop;
  return operation.reads ? CallEffect::none : CallEffect::change;
}

/// Whether it moves something, or moves it otherwise: the cell lets it through, or not.
inline bool moves(CallEffect effect) { return effect >= CallEffect::pace; }

}  // namespace race::rsm
