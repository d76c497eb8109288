#include "tests/unit/core/language/program_generator.h"

namespace race::language::test {

namespace {
constexpr const char* kStore = "res.out = [i0, i1, r0, r1, b0, b1, s0, s1, l0, l1, d0, d1]";
}  // namespace

std::string ProgramGenerator::program() {
  out_.clear();
  loops_ = 0;
  line(0, "i0, i1 = " + literal(Type::integer) + ", " + literal(Type::integer));
  line(0, "r0, r1 = " + literal(Type::real) + ", " + literal(Type::real));
  line(0, "b0 = " + literal(Type::boolean));
  line(0, "b1 = " + literal(Type::boolean));
  line(0, "s0, s1 = " + literal(Type::text) + ", " + literal(Type::text));
  line(0, "l0, l1 = " + literal(Type::list) + ", " + literal(Type::list));
  line(0, "d0, d1 = " + literal(Type::dict) + ", " + literal(Type::dict));
  if (chance(10)) line(0, "if b0:\n    late = 1");
  block(3, 0, 3 + below(5));
  if (chance(10)) line(0, "if b1:\n    late = 2\ni0 = late");
  line(0, kStore);
  out_.pop_back();
  return out_;
}

void ProgramGenerator::line(std::size_t indent, const std::string& text) {
  out_ += std::string(indent * 4, ' ') + text + "\n";
}

void ProgramGenerator::block(int depth, std::size_t indent, std::size_t statements) {
  for (std::size_t i = 0; i < statements; ++i) {
    statement(depth, indent);
    if (indent == 0) line(0, kStore);  // so that a fault leaves something to compare
  }
}

std::string ProgramGenerator::name(Type type) {
  static constexpr const char* kLetters[] = {"i", "r", "b", "s", "l", "d"};
  return kLetters[static_cast<std::size_t>(type)] + std::to_string(below(2));
}

void ProgramGenerator::statement(int depth, std::size_t indent) {
  const Type type = any_type();
  switch (below(depth > 0 ? 15 : 10)) {
    case 0:
    case 1:
    case 2:
      return line(indent, name(type) + " = " + expression(type, 3));
    case 3:
      return line(indent, name(Type::integer) + " " + pick({"+", "-", "*", "//"}) + "= " + integer(2));
    case 4:
      return line(indent, name(Type::real) + " " + pick({"+", "-", "*", "/"}) + "= " + real(2));
    case 5:
      return line(indent, name(Type::text) + " += " + text(2));
    case 6: {
      const std::string l = name(Type::list);
      switch (below(9)) {
        case 0:
          return line(indent, l + ".append(" + expression(any_type(), 2) + ")");
        case 1:
          return line(indent, l + ".extend(" + list(2) + ")");
        case 2:
          return line(indent,
                      l + ".insert(+" + in_brackets(Type::integer, 1) + " % 5, " + expression(any_type(), 1) + ")");
        case 3:
          return line(indent, "if " + l + ":\n" + std::string(indent * 4 + 4, ' ') + l + ".pop()");
        case 4:
          return line(indent, l + ".reverse()");
        case 5:
          if (chance(85)) return line(indent, l + " = sorted([str(x) for x in " + l + "])");
          return line(indent, l + ".sort()");
        case 6:
          return line(indent, l + (chance(70) ? "[-1] = " : "[+" + in_brackets(Type::integer, 1) + " % 4] = ") +
                                  expression(any_type(), 2));
        case 7:
          return line(indent, l + ".remove(" + (chance(70) ? l + "[0]" : expression(any_type(), 1)) + ")");
        default:
          return line(indent, l + " += " + list(1));
      }
    }
    case 7: {
      const std::string d = name(Type::dict);
      switch (below(6)) {
        case 0:
          return line(indent, d + ".update(" + dict(2) + ")");
        case 1:
          return line(indent, d + ".setdefault(" + key() + ", " + expression(any_type(), 1) + ")");
        case 2:
          return line(indent, d + ".pop(" + text(1) + ", None)");
        case 3:
          line(indent, d + "['k'] = 1");
          return line(indent, d + "[" + (chance(70) ? "'k'" : text(1)) + "] += " + integer(1));
        default:
          return line(indent, d + "[" + key() + "] = " + expression(any_type(), 2));
      }
    }
    case 8:
      return line(indent, name(type) + ", " + name(type) + " = " + expression(type, 2) + ", " + expression(type, 2));
    case 9:
      return line(indent, name(Type::integer) + " = " + name(chance(90) ? Type::integer : any_type()) +
                              pick({" + ", " * 2 + ", " - "}) + name(chance(90) ? Type::boolean : any_type()));
    case 10:
    case 11:
      line(indent, "if " + boolean(3) + ":");
      block(depth - 1, indent + 1, 1 + below(2));
      if (chance(40)) {
        line(indent, "elif " + boolean(2) + ":");
        block(depth - 1, indent + 1, 1);
      }
      if (chance(50)) {
        line(indent, "else:");
        block(depth - 1, indent + 1, 1);
      }
      return;
    case 12: {
      const std::string counter = "c" + std::to_string(loops_++);
      line(indent, counter + " = 0");
      line(indent, "while " + counter + " < " + std::to_string(1 + below(4)) + ":");
      line(indent + 1, counter + " += 1");
      if (chance(30)) line(indent + 1, "if " + boolean(1) + ": " + pick({"break", "continue"}));
      return block(depth - 1, indent + 1, 1 + below(2));
    }
    case 13:
      line(indent, "for i1 in range(" + std::to_string(below(5)) + "):");
      if (chance(30)) line(indent + 1, "if " + boolean(1) + ": " + pick({"break", "continue"}));
      return block(depth - 1, indent + 1, 1 + below(2));
    default: {
      const std::string x = "x" + std::to_string(loops_++);
      line(indent, "for " + x + " in " + pick({"l0", "d0", "s0", "enumerate(l1)", "zip(l0, l1)", "d1.items()"}) + ":");
      line(indent + 1, "l1 = [" + x + ", " + expression(any_type(), 1) + "]");
      return block(depth - 1, indent + 1, 1);
    }
  }
}

std::string ProgramGenerator::literal(Type type) {
  switch (type) {
    case Type::integer:
      return pick({"0", "1", "2", "3", "-1", "-7", "10", "255", "-100", "0x1f", "1_000"});
    case Type::real:
      return pick({"0.0", "1.0", "-1.5", "0.1", "2.5", "3.5", "-0.0", "1e16", "1e-5", "123456.789", "1e300",
                   "0.30000000000000004"});
    case Type::boolean:
      return pick({"True", "False"});
    case Type::text:
      return pick(
          {"''", "'a'", "\"it's\"", "'abc'", "'a,b, c'", "'Hello World'", "'äöß€'", "'\\n\\t\\\\'", "'12'", "' x '"});
    case Type::list:
      return pick(
          {"[]", "[1]", "[3, 1, 2]", "['b', 'a']", "[1, 2.5, True]", "[[1, 2], [3]]", "[0, 0.0, False, '', None]"});
    default:
      return pick({"{}", "{'a': 1}", "{'b': 2, 'a': [1, 2]}", "{'abc': {'x': 1.5}, '12': None}"});
  }
}

std::string ProgramGenerator::divisor(int depth) {
  if (chance(10)) return in_brackets(chance(50) ? Type::integer : Type::real, depth);
  return pick({"2", "3", "-4", "7.5", "-0.5", "(abs(i0) + 1)"});
}

std::string ProgramGenerator::key() { return chance(50) ? literal(Type::text) : "str(" + text(1) + ")"; }

std::string ProgramGenerator::expression(Type type, int depth) {
  if (below(400) == 0) type = any_type();  // now and then of a type that does not fit
  if (depth <= 0 || chance(15)) return chance(60) ? name(type) : literal(type);
  if (chance(4)) {
    return "(" + expression(type, depth - 1) + " if " + boolean(depth - 1) + " else " + expression(type, depth - 1) +
           ")";
  }
  switch (type) {
    case Type::integer:
      return integer(depth - 1);
    case Type::real:
      return real(depth - 1);
    case Type::boolean:
      return boolean(depth - 1);
    case Type::text:
      return text(depth - 1);
    case Type::list:
      return list(depth - 1);
    default:
      return dict(depth - 1);
  }
}

std::string ProgramGenerator::integer(int depth) {
  if (depth <= 0) return chance(60) ? name(Type::integer) : literal(Type::integer);
  const auto part = [&] { return in_brackets(Type::integer, depth); };
  switch (below(16)) {
    case 0:
      return part() + " + " + part();
    case 1:
      return part() + " - " + part();
    case 2:
      return part() + " * " + part();
    case 3:
      return part() + " // " + divisor(depth);
    case 4:
      return "+" + part() + " % " + divisor(depth);  // the sign: a text before % is not in the language
    case 5:
      return part() + " ** (+" + in_brackets(Type::integer, depth - 1) + " % 4)";
    case 6:
      return "-" + part();
    case 7:
      return "abs(" + expression(Type::integer, depth) + ")";
    case 8:
      return "len(" + expression(static_cast<Type>(3 + below(3)), depth) + ")";
    case 9:
      return "int(" +
             (chance(60)   ? "math.tanh(" + expression(Type::real, depth) + ") * 100"
              : chance(70) ? "'-0042 '"
                           : expression(chance(50) ? Type::real : Type::text, depth)) +
             ")";
    case 10:
      return "round(" + expression(Type::real, depth) + ")";
    case 11:
      return "sum([" + expression(Type::integer, depth) + ", " + expression(Type::integer, depth) + "])";
    case 12:
      return pick({"min(", "max("}) + expression(Type::integer, depth) + ", " + expression(Type::integer, depth) + ")";
    case 13:
      return in_brackets(Type::text, depth) + pick({".find(", ".count(", ".find(", ".rfind("}) +
             expression(Type::text, depth) + ")";
    case 14:
      return "math." + pick({"floor(", "ceil(", "trunc("}) + expression(Type::real, depth) + ")";
    default:
      return chance(85) ? "([7] + " + in_brackets(Type::list, depth) + ")[0]"
                        : in_brackets(Type::list, depth) + "[" + integer(depth - 1) + "]";
  }
}

std::string ProgramGenerator::real(int depth) {
  if (depth <= 0) return chance(60) ? name(Type::real) : literal(Type::real);
  const auto part = [&] { return in_brackets(chance(75) ? Type::real : Type::integer, depth); };
  switch (below(12)) {
    case 0:
      return part() + " + " + part();
    case 1:
      return part() + " - " + part();
    case 2:
      return part() + " * " + part();
    case 3:
      return part() + " / " + divisor(depth);
    case 4:
      return part() + " // " + divisor(depth);
    case 5:
      return "+" + part() + " % " + divisor(depth);
    case 6:
      return part() + " ** " + std::to_string(below(4));
    case 7:
      return "float(" + expression(chance(95) ? Type::integer : Type::text, depth) + ")";
    case 8:
      return "round(" + expression(Type::real, depth) + ", " + std::to_string(static_cast<int>(below(6)) - 2) + ")";
    case 9:
      return "math." + pick({"atan(", "sin(", "cos(", "atan(", "tanh(", "asinh(", "fabs(", "tanh(", "degrees("}) +
             part() + ")";
    case 10:
      return "math." + pick({"atan2(", "hypot(", "fmod(", "copysign("}) + part() + ", " + part() + ")";
    default:
      return "-" + part();
  }
}

std::string ProgramGenerator::boolean(int depth) {
  if (depth <= 0) return chance(60) ? name(Type::boolean) : literal(Type::boolean);
  const Type type = any_type();
  const auto part = [&](Type t) { return in_brackets(t, depth); };
  switch (below(12)) {
    case 0:
    case 1:
      return part(type) + pick({" == ", " != "}) + part(chance(80) ? type : any_type());
    case 2:
    case 3: {
      const Type other = chance(50) ? Type::integer : Type::real;
      return part(Type::integer) + pick({" < ", " <= ", " > ", " >= "}) + part(other);
    }
    case 4:
      return part(Type::text) + pick({" < ", " in ", " not in ", " >= "}) + part(Type::text);
    case 5:
      return part(any_type()) + pick({" in ", " not in "}) + part(Type::list);
    case 6:
      return part(Type::boolean) + pick({" and ", " or "}) + part(Type::boolean);
    case 7:
      return "not " + part(any_type());
    case 8:
      return part(Type::integer) + " < " + part(Type::integer) + pick({" < ", " != ", " >= "}) + part(Type::real);
    case 9:
      return pick({"all(", "any("}) + expression(Type::list, depth) + ")";
    case 10:
      return part(Type::text) + "." +
             pick({"isalpha()", "isdigit()", "isupper()", "islower()", "isspace()", "isalnum()", "startswith(s0)",
                   "endswith('c')"});
    default:
      return part(any_type()) + pick({" is None", " is not None"});
  }
}

std::string ProgramGenerator::text(int depth) {
  if (depth <= 0) return chance(60) ? name(Type::text) : literal(Type::text);
  const auto part = [&] { return in_brackets(Type::text, depth); };
  switch (below(12)) {
    case 0:
      return part() + " + " + part();
    case 1:
      return part() + " * " + std::to_string(below(4));
    case 2:
      return chance(85) ? "(" + part() + " + 'zé')[" + std::to_string(static_cast<int>(below(4)) - 2) + "]"
                        : part() + "[" + integer(depth - 1) + "]";
    case 3:
      return part() + "[" + std::to_string(static_cast<int>(below(7)) - 3) + ":" +
             std::to_string(static_cast<int>(below(7)) - 3) + "]";
    case 4:
      return part() + "[::" + pick({"-1", "2", "-2", "1"}) + "]";
    case 5:
      return "str(" + expression(any_type(), depth) + ")";
    case 6:
      return part() + "." +
             pick({"upper()", "lower()", "strip()", "title()", "capitalize()", "swapcase()", "zfill(6)",
                   "center(9, '*')", "ljust(5)", "rjust(5)"});
    case 7:
      return part() + ".replace(" + expression(Type::text, depth - 1) + ", " + expression(Type::text, depth - 1) + ")";
    case 8:
      return in_brackets(Type::dict, depth) + ".get(" + expression(Type::text, depth - 1) + ", 'none')";
    case 9:
      return "f\"{" + name(Type::real) + ":" + pick({".2f", "8.3e", "g", "+.1f", "012.4f", ",.2f", ".3%", "^10.1f"}) +
             "}|{" + name(Type::integer) + ":" + pick({"d", "5d", "<6", "x", "#b", "+,", "08", "_"}) + "}\"";
    case 10:
      return "f\"{" + name(any_type()) + "}{" + name(Type::text) + "!r:>8}{" + name(Type::list) + "}\"";
    default:
      return part() + ".join([str(x) for x in " + expression(Type::list, depth - 1) + "])";
  }
}

std::string ProgramGenerator::list(int depth) {
  if (depth <= 0) return chance(60) ? name(Type::list) : literal(Type::list);
  const auto part = [&] { return in_brackets(Type::list, depth); };
  switch (below(12)) {
    case 0:
      return part() + " + " + part();
    case 1:
      return part() + " * " + std::to_string(below(3));
    case 2:
      return part() + "[" + std::to_string(static_cast<int>(below(5)) - 2) + ":]";
    case 3:
      return "[" + expression(any_type(), depth) + ", " + expression(any_type(), depth) + "]";
    case 4:
      return "sorted(" + expression(chance(90) ? Type::text : Type::list, depth) +
             pick({"", ", reverse=True", ", reverse=False"}) + ")";
    case 5:
      return "list(" + expression(chance(50) ? Type::text : Type::dict, depth) + ")";
    case 6:
      return "[" + pick({"x", "[x, x]", "str(x)", "(x == i0)"}) + " for x in " + expression(Type::list, depth) + "]";
    case 7:
      return "[x for x in range(" + std::to_string(below(6)) + ") if x % 2 == " + std::to_string(below(2)) + "]";
    case 8:
      return "reversed(" + expression(Type::list, depth) + ")";
    case 9:
      return in_brackets(Type::text, depth) +
             pick({".split()", ".split(',')", ".split('a', 1)", ".splitlines()", ".partition('b')", ".rsplit(',', 1)"});
    case 10:
      return in_brackets(Type::dict, depth) + pick({".keys()", ".values()", ".items()"});
    default:
      return "[[x, y] for x in " + part() + " for y in 'ab' if x]";
  }
}

std::string ProgramGenerator::dict(int depth) {
  if (depth <= 0) return chance(60) ? name(Type::dict) : literal(Type::dict);
  switch (below(4)) {
    case 0:
      return "{" + key() + ": " + expression(any_type(), depth) + ", 'k': " + expression(any_type(), depth) + "}";
    case 1:
      return "dict(" + expression(Type::dict, depth) + ")";
    case 2:
      return "dict(a=" + expression(any_type(), depth) + ", b=" + expression(any_type(), depth) + ")";
    default:
      return in_brackets(Type::dict, depth) + ".copy()";
  }
}

}  // namespace race::language::test
