// Generates random programs of the function language, mostly well typed, to compare two implementations. Loops end,
// numbers of repetitions are small, and the last statement stores what every name holds in res.out.
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace race::language::test {

class ProgramGenerator {
 public:
  explicit ProgramGenerator(std::uint32_t seed) : random_(seed) {}
  std::string program();

 private:
  enum class Type : std::uint8_t { integer, real, boolean, text, list, dict };

  std::size_t below(std::size_t n) { return random_() % n; }
  bool chance(std::size_t percent) { return below(100) < percent; }
  template <std::size_t N>
  std::string pick(const char* const (&choices)[N]) {
    return choices[below(N)];
  }

  void block(int depth, std::size_t indent, std::size_t statements);
  void statement(int depth, std::size_t indent);
  void line(std::size_t indent, const std::string& text);
  std::string name(Type type);
  Type any_type() { return static_cast<Type>(below(6)); }

  std::string expression(Type type, int depth);
  std::string integer(int depth);
  std::string real(int depth);
  std::string boolean(int depth);
  std::string text(int depth);
  std::string list(int depth);
  std::string dict(int depth);
  std::string literal(Type type);
  std::string divisor(int depth);  // mostly not zero
  std::string key();  // a text, whatever goes wrong in it: keys of other types are the language's own fault
  std::string in_brackets(Type type, int depth) { return "(" + expression(type, depth) + ")"; }

  std::mt19937 random_;
  std::string out_;
  int loops_ = 0;
};

}  // namespace race::language::test
