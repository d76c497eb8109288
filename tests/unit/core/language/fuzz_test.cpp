// Random texts: checking always ends with a result; accepted code compiles, runs and ends.
#include <gtest/gtest.h>

#include <iostream>
#include <random>

#include "core/language/evaluate/explain.h"
#include "core/language/values/printing.h"
#include "core/language/values/values.h"
#include "tests/unit/core/language/environment.h"
#include "tests/unit/core/language/program_generator.h"

namespace race::language::test {
namespace {

constexpr std::uint32_t kTextSeed = 7;

constexpr const char* kPieces[] = {" ",
                                   " ",
                                   " ",
                                   "\n",
                                   "\n    ",
                                   "\n        ",
                                   "\t",
                                   "(",
                                   ")",
                                   "[",
                                   "]",
                                   "{",
                                   "}",
                                   ",",
                                   ":",
                                   ".",
                                   ";",
                                   "=",
                                   "==",
                                   "+",
                                   "-",
                                   "*",
                                   "/",
                                   "//",
                                   "%",
                                   "**",
                                   "+=",
                                   "<",
                                   ">=",
                                   "!=",
                                   "if",
                                   "elif",
                                   "else",
                                   "for",
                                   "in",
                                   "while",
                                   "not",
                                   "and",
                                   "or",
                                   "is",
                                   "None",
                                   "True",
                                   "pass",
                                   "break",
                                   "continue",
                                   "lambda",
                                   "import",
                                   "def",
                                   "class",
                                   "try",
                                   "x",
                                   "y",
                                   "par.a",
                                   "res.x",
                                   "res.out",
                                   "var.n",
                                   "chi.C",
                                   "port.p",
                                   "svc.t.data",
                                   "svc.t.op",
                                   "svc[x]",
                                   "math.sin",
                                   "geo.pose",
                                   "len",
                                   "range",
                                   "print",
                                   "available",
                                   "append",
                                   "pop",
                                   "0",
                                   "1",
                                   "-1",
                                   "2.5",
                                   "1e9",
                                   "9223372036854775807",
                                   "'a'",
                                   "\"b\"",
                                   "f'{x}'",
                                   "f'{x:{y}}'",
                                   "'",
                                   "\"",
                                   "'''",
                                   "f'",
                                   "{x",
                                   "\\",
                                   "\\n",
                                   "#",
                                   "é",
                                   "\x80",
                                   "\xff",
                                   "@",
                                   "~",
                                   ":=",
                                   "...",
                                   "0x",
                                   "1_",
                                   "[x for x in y]",
                                   "x[1:2]"};

std::string random_tokens(std::mt19937& random) {
  std::string text;
  const std::size_t pieces = 1 + random() % 40;
  for (std::size_t i = 0; i < pieces; ++i) {
    text += kPieces[random() % std::size(kPieces)];
    if (random() % 3 == 0) text += ' ';
  }
  return text;
}

// A good program with some bytes changed.
std::string damaged(std::mt19937& random) {
  std::string text = ProgramGenerator(static_cast<std::uint32_t>(random())).program();
  const std::size_t changes = random() % 4;
  for (std::size_t i = 0; i < changes; ++i) {
    const std::size_t at = random() % text.size();
    const std::string piece = kPieces[random() % std::size(kPieces)];
    text.replace(at, random() % 4, piece);
  }
  return text;
}

constexpr Interpreter::Limits kLimits = {.steps = 2000, .value_units = 10'000};

// Stored values are within the limits, and read back as they are printed.
void stored_well(const Value& v, const std::string& text) {
  if (v.is_unknown()) return;
  const Measure size = measure(v, kLimits.value_units);
  ASSERT_LE(size.units, kLimits.value_units) << text;
  ASSERT_LE(size.depth, kMaxValueDepth) << text;
  ASSERT_TRUE(size.finite) << text;
  const std::string printed = repr(v);
  Runner r;
  const Code code = r.code(printed, CodeKind::expression);
  ASSERT_TRUE(code) << printed;
  const auto again = r.interpreter.expression(code, r.state);
  ASSERT_TRUE(again) << printed;
  ASSERT_EQ(repr(*again), printed) << text;
}

void run(const std::string& text, CodeKind kind) {
  Runner r(kLimits);
  r.state.set(State::par_a, Value(List{1, "a"}));
  r.state.set(State::res_x, Value(1));
  r.state.set(State::var_n, Value(Dict{{"k", Value(2)}}));
  r.state.deliver(0, Value(Dict{{"x", Value(1.5)}}));
  for (const std::string& name : variable_names(text)) r.state.symbols.variables.emplace(name, State::var_log);
  const auto errors = check(text, kind, r.state.symbols);
  const auto code = compile(text, kind, r.state.symbols, r.state.table);
  ASSERT_EQ(errors.empty(), code.has_value()) << text;
  if (!code) return;
  if (kind == CodeKind::function) {
    r.interpreter.function(*code, r.state);
    for (const ValueIndex slot :
         std::initializer_list<ValueIndex>{State::res_out, State::res_x, State::var_n, State::var_log})
      stored_well(r.state.at(slot), text);
  }
  if (kind == CodeKind::expression) r.interpreter.expression(*code, r.state);
  if (kind != CodeKind::condition) return;
  r.interpreter.condition(*code, r.state);
  explain(*code, r.state);
}

TEST(Fuzz, RandomTokensAreCheckedAndRun) {
  std::cout << "seed " << kTextSeed << "\n";
  std::mt19937 random(kTextSeed);
  for (int i = 0; i < 30'000; ++i) run(random_tokens(random), static_cast<CodeKind>(random() % 3));
}

TEST(Fuzz, DamagedProgramsAreCheckedAndRun) {
  std::cout << "seed " << kTextSeed << "\n";
  std::mt19937 random(kTextSeed);
  for (int i = 0; i < 3'000; ++i) run(damaged(random), CodeKind::function);
}

}  // namespace
}  // namespace race::language::test
