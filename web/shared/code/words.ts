// The words of the function language: its keywords, functions, methods and constants. A test compares them with the tables of core/language.

/** Those of Python; the language knows the meaning of some. */
export const kKeywords = [
  "False", "None", "True", "and", "as", "assert", "async", "await", "break", "class", "continue", "def", "del", "elif", "else", "except", "finally", "for",
  "from", "global", "if", "import", "in", "is", "lambda", "nonlocal", "not", "or", "pass", "raise", "return", "try", "while", "with", "yield",
] as const;

/** Keywords that an expression may have, and those that a function may have besides. */
export const kExpressionKeywords = ["False", "None", "True", "and", "else", "for", "if", "in", "is", "not", "or"] as const;
export const kStatementKeywords = ["break", "continue", "elif", "pass", "while"] as const;

/** What begins the name of something outside of a text (core/SEMANTICS.md, section 2). */
export const kCollections = {
  par: "Parameters of the state: they are read.",
  res: "Results of the state: they are read, and written by functions.",
  var: "Variables of the state: they are read, and written by functions.",
  port: "Ports of the state: whether they are active.",
  chi: "Children of the state: their parameters, results and ports, and whether they are active.",
  svc: "Services: calls of their operations, what these answered, and their events.",
} as const;

export type Collection = keyof typeof kCollections;

export const isCollection = (name: string): name is Collection => Object.hasOwn(kCollections, name);

/** A function: its parameters as core/language/library/functions.h writes them, and what it gives. */
export interface LanguageFunction {
  readonly name: string;
  readonly parameters: string;
  readonly doc: string;
}

const table = (...rows: readonly (readonly [name: string, parameters: string, doc: string])[]): readonly LanguageFunction[] => rows.map(([name, parameters, doc]) => ({ name, parameters, doc }));

export const kBuiltins = table(
  ["abs", "x", "The absolute value of a number."],
  ["all", "iterable", "Whether all items are true."],
  ["any", "iterable", "Whether one of the items is true."],
  ["bool", "x?", "Whether a value is true."],
  ["dict", "x? *", "A dict of another one, of pairs, or of the named arguments."],
  ["enumerate", "iterable= start?=", "Pairs of a number, from `start` on, and an item."],
  ["float", "x?", "A number or text as a floating-point number."],
  ["int", "x? base?=", "A number, cut, or a text as a whole number."],
  ["len", "x", "How many items a list or dict, or characters a text has."],
  ["list", "iterable?", "A list of the items."],
  ["log", "sep! end! *", "Writes values to the log of the run, as print."],
  ["max", "default! *", "The greatest of the arguments, or of the items of one list."],
  ["min", "default! *", "The least of the arguments, or of the items of one list."],
  ["print", "sep! end! *", "Writes values to the log of the run."],
  ["range", "start stop? step?", "Whole numbers from `start` on, before `stop`."],
  ["reversed", "sequence", "The items, last first."],
  ["round", "number= ndigits?=", "A number rounded to `ndigits` decimals, half to even."],
  ["sorted", "iterable reverse!", "The items in order, as a new list."],
  ["str", "object?=", "A value as text."],
  ["sum", "iterable start?=", "The sum of the items."],
  ["zip", "*", "Lists of the first items of all arguments, of the second ones, and so on."],
);

/** Not in the tables of core/language, as the interpreter itself implements it. */
export const kAvailable: LanguageFunction = { name: "available", parameters: "x", doc: "Whether a value is known: data of a service has arrived, or a result has been written." };

const kMath = table(
  ["acos", "x", "The angle of this cosine [rad]."],
  ["acosh", "x", "The inverse hyperbolic cosine."],
  ["asin", "x", "The angle of this sine [rad]."],
  ["asinh", "x", "The inverse hyperbolic sine."],
  ["atan", "x", "The angle of this tangent [rad]."],
  ["atan2", "y x", "The angle of the point (x, y) [rad]."],
  ["atanh", "x", "The inverse hyperbolic tangent."],
  ["ceil", "x", "The least whole number that is not less."],
  ["copysign", "x y", "`x` with the sign of `y`."],
  ["cos", "x", "The cosine of an angle [rad]."],
  ["cosh", "x", "The hyperbolic cosine."],
  ["degrees", "x", "An angle [rad] in degrees."],
  ["exp", "x", "e to the power of `x`."],
  ["fabs", "x", "The absolute value, as a floating-point number."],
  ["floor", "x", "The greatest whole number that is not greater."],
  ["fmod", "x y", "The remainder of `x / y`, with the sign of `x`."],
  ["hypot", "*", "The length of a vector with these components."],
  ["isclose", "a= b= rel_tol! abs_tol!", "Whether two numbers are nearly the same."],
  ["isfinite", "x", "Whether a number is neither infinite nor no number."],
  ["isinf", "x", "Whether a number is infinite."],
  ["isnan", "x", "Whether it is no number."],
  ["log", "x base?", "The logarithm to a base, or the natural one."],
  ["log10", "x", "The logarithm to the base 10."],
  ["log2", "x", "The logarithm to the base 2."],
  ["pow", "x y", "`x` to the power of `y`."],
  ["radians", "x", "An angle in degrees in radians."],
  ["sin", "x", "The sine of an angle [rad]."],
  ["sinh", "x", "The hyperbolic sine."],
  ["sqrt", "x", "The square root."],
  ["tan", "x", "The tangent of an angle [rad]."],
  ["tanh", "x", "The hyperbolic tangent."],
  ["trunc", "x", "The number without its decimals."],
);

const kGeo = table(
  ["angle", "a= b=", "The angle between the orientations of two poses [rad]."],
  ["compose", "a= b=", "The pose `b`, which is seen from `a`, as it is seen from where `a` is seen."],
  ["distance", "a= b=", "The distance between the positions of two poses [m]."],
  ["identity", "", "The pose at the origin, not turned."],
  ["interpolate", "a= b= s=", "The pose between `a` (`s` = 0) and `b` (`s` = 1)."],
  ["inverse", "a=", "The origin as it is seen from the pose `a`."],
  ["mean", "poses=", "The mean of poses."],
  ["offset", "pose= x= y= z=", "The pose, moved along its own axes [m]."],
  ["pose", "position= orientation=", "A pose of a position [x, y, z] [m] and a quaternion [qx, qy, qz, qw]."],
  ["rpy", "r= p= y=", "The quaternion of roll, pitch and yaw [rad]."],
  ["to_rpy", "pose=", "Roll, pitch and yaw of a pose [rad]."],
  ["transform", "a= point=", "A point that is seen from the pose `a`, as it is seen from where `a` is seen."],
);

export interface Module {
  readonly doc: string;
  readonly functions: readonly LanguageFunction[];
  readonly constants: readonly string[];
}

export const kModules: Readonly<Record<string, Module>> = {
  math: { doc: "Functions of numbers; angles in radians.", functions: kMath, constants: ["pi", "e", "tau", "inf", "nan"] },
  geo: { doc: "Poses {\"position\": [x, y, z], \"orientation\": [qx, qy, qz, qw]}, in metres.", functions: kGeo, constants: [] },
};

/** Parameters as a person writes a call: `x, base=…`; one in brackets may be left out. */
export function parametersText(parameters: string): string {
  const words = parameters.split(" ").filter((word) => word !== "");
  // Those that are given by their name only stand last.
  const order = (word: string): number => (word === "*" ? 1 : word.endsWith("!") ? 2 : 0);
  const shown = (word: string): string => {
    const name = word.replace(/[?=!]+$/, "");
    if (word === "*") return "…";
    return word.endsWith("!") ? `[${name}=]` : word.includes("?") ? `[${name}]` : name;
  };
  return [...words].sort((a, b) => order(a) - order(b)).map(shown).join(", ");
}
