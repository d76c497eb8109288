// Opcode: what the nodes of a Program compute and do.
#pragma once

#include <cstdint>

#include "core/language/syntax/operators.h"

namespace race::language {

/// What a node computes or does. Letters in comments are its fields; "run" is [a, count], a part of `Program::runs`.
enum class Opcode : std::uint8_t {
  // Leaves: a = number of the constant, local, slot, flag, event or operation.
  constant,
  local,
  slot,
  flag,
  event,          // data of the occurrence, or of the newest sample
  event_present,  // in a boolean position: true or unknown
  event_latest,
  response,  // b = 1: the error
  response_present,
  dynamic_event,     // a = service, b = constant with the event's name, c = a DynamicRead
  dynamic_response,  // a = service, b = constant with the operation's name, c = 1: the error, 2: presence (bits)
  collection,        // a = number of the collection
  // Operators.
  field,     // a . constant b
  index,     // a [b]
  slice,     // run of object, low, high, step; kNone where one is missing
  negative,  // a; so are the next two
  positive,
  logical_not,
  add,  // a op b; so are those down to is_not_none
  subtract,
  multiply,
  divide,
  floor_divide,
  modulo,
  power,
  less,
  less_equal,
  greater,
  greater_equal,
  equal,
  not_equal,
  in,
  not_in,
  is_none,
  is_not_none,
  logical_and,       // run
  logical_or,        // run
  chain,             // run of operand, operator, operand, operator, operand ...; the operators are BinaryOperators
  conditional,       // a if b then, c else
  list,              // run
  dict,              // run of key, value, ...
  comprehension,     // a = element, b = number of the comprehension
  fstring,           // run
  format,            // a printed after conversion c to format b (kNone: none)
  available,         // a
  function,          // b = number of the call, run of arguments, kNone where one is not given
  method,            // b = number of the method call, run of object and arguments
  mutate,            // b = number of the method call, run of arguments; changes a place
  mutate_temporary,  // b = number of the method call, run of object and arguments; changes a temporary value
  invalid_call,      // run of arguments, then a type fault with the message of constant b
  copy,              // a copy of a, which a later part of the expression may change
  // Statements.
  block,          // run
  evaluate,       // a
  assign_local,   // a to local b
  assign_slot,    // a to slot b
  assign,         // a to the targets of a run
  augment_local,  // local a, BinaryOperator c, value b
  augment_slot,
  augment_place,  // a = number of the place
  branch,         // run of test, block, test, block, ..., [block]
  for_loop,       // for target a in b: block c
  while_loop,     // while a: block b
  break_loop,
  continue_loop,
  pass,
  call_service,  // a = number of the service call
  // Targets.
  target_local,   // a
  target_slot,    // a
  target_place,   // a = number of the place
  target_unpack,  // run of targets
};

// The operators of the text are opcodes in the same order.
constexpr Opcode opcode(UnaryOperator op) {
  return static_cast<Opcode>(static_cast<int>(Opcode::negative) + static_cast<int>(op));
}
constexpr Opcode opcode(BinaryOperator op) {
  return static_cast<Opcode>(static_cast<int>(Opcode::add) + static_cast<int>(op));
}
/// Requires the opcode of such an operator.
constexpr UnaryOperator unary_operator(Opcode op) {
  return static_cast<UnaryOperator>(static_cast<int>(op) - static_cast<int>(Opcode::negative));
}
constexpr BinaryOperator binary_operator(Opcode op) {
  return static_cast<BinaryOperator>(static_cast<int>(op) - static_cast<int>(Opcode::add));
}
static_assert(opcode(UnaryOperator::logical_not) == Opcode::logical_not);
static_assert(opcode(BinaryOperator::power) == Opcode::power && opcode(BinaryOperator::less) == Opcode::less);
static_assert(opcode(BinaryOperator::is_none) == Opcode::is_none);
static_assert(opcode(BinaryOperator::logical_or) == Opcode::logical_or);

}  // namespace race::language
