"""Prints unicode_tables.cpp from what this Python knows about every code point (run it with Python 3.11)."""
import sys

POINTS = [c for c in range(sys.maxunicode + 1) if not 0xD800 <= c <= 0xDFFF]


def runs(points, key=lambda c: 0):
    """Greedy arithmetic progressions of stride 1 or 2 with equal key."""
    out = []
    i = 0
    while i < len(points):
        best = i
        best_stride = 1
        for stride in (1, 2):
            j = i
            while j + 1 < len(points) and points[j + 1] == points[j] + stride and key(points[j + 1]) == key(points[i]):
                j += 1
            if j > best:
                best, best_stride = j, stride
        out.append((points[i], points[best], best_stride, key(points[i])))
        i = best + 1
    return out


def write(items, per_line):
    for i in range(0, len(items), per_line):
        print("    " + ", ".join(items[i:i + per_line]) + ",")


def ranges(name, predicate):
    print(f"constexpr Range k{name}Ranges[] = {{")
    write([f"{{0x{a:X}, 0x{b:X}, {s}}}" for a, b, s, _ in runs([c for c in POINTS if predicate(chr(c))])], 5)
    print(f"}};\nconst std::span<const Range> k{name} = k{name}Ranges;\n")


def shifts(name, method):
    short = [c for c in POINTS if len(method(chr(c))) == 1 and method(chr(c)) != chr(c)]
    print(f"constexpr Shift kTo{name}Shifts[] = {{")
    write([f"{{0x{a:X}, 0x{b:X}, {s}, {d}}}" for a, b, s, d in runs(short, lambda c: ord(method(chr(c))) - c)], 4)
    print(f"}};\nconst std::span<const Shift> kTo{name} = kTo{name}Shifts;\n")
    print(f"constexpr Expansion kLong{name}Expansions[] = {{")
    rows = []
    for c in POINTS:
        to = method(chr(c))
        if len(to) > 1:
            rows.append(f"{{0x{c:X}, {{" + ", ".join(f"0x{ord(x):X}" for x in to.ljust(3, chr(0))) + "}}")
    write(rows, 4)
    print(f"}};\nconst std::span<const Expansion> kLong{name} = kLong{name}Expansions;\n")


def case_ignorable(c):
    # A final sigma shows it: Python skips case-ignorable characters when it looks for the letter before.
    return ("A" + c + "\u03a3").lower().endswith("\u03c2") and ("1" + c + "\u03a3").lower().endswith("\u03c3")


print("// Made by unicode_tables.py; see unicode.h.")
print("// clang-format off")
print('#include "core/language/primitives/unicode.h"\n\nnamespace race::language::unicode {\n')
ranges("Alpha", str.isalpha)
ranges("Decimal", str.isdecimal)
ranges("Digit", str.isdigit)
ranges("Numeric", str.isnumeric)
ranges("Space", str.isspace)
ranges("Upper", str.isupper)
ranges("Lower", str.islower)
ranges("Title", lambda c: c.istitle() and not c.isupper())
ranges("Printable", str.isprintable)
ranges("CaseIgnorable", case_ignorable)
shifts("Upper", str.upper)
shifts("Lower", str.lower)
shifts("Title", str.title)
print("}  // namespace race::language::unicode")
