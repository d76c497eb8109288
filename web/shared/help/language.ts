// The reference of the function language, made of the tables by which the editor completes (../code), which a test holds equal to core/language.
import { kDictMethods, kListMethods, kTextMethods } from "../code/methods";
import { kAvailable, kBuiltins, kCollections, kExpressionKeywords, kModules, kStatementKeywords, parametersText, type LanguageFunction } from "../code/words";
import { code, list, terms, text, type Block, type Topic } from "./blocks";

const group = "Function language" as const;

const functionsBlock = (functions: readonly LanguageFunction[], module = ""): Block => ({
  kind: "terms",
  terms: functions.map(({ name, parameters, doc }) => ({ name: `${module}${name}(${parametersText(parameters)})`, text: doc })),
});

/** What the methods do is Python's; those that take a value to pieces give new values. */
const methodsBlock = (methods: Readonly<Record<string, string>>): Block => ({
  kind: "list",
  items: Object.entries(methods).map(([name, parameters]) => `\`${name}(${parametersText(parameters)})\``),
});

export const language: readonly Topic[] = [
  {
    id: "language", title: "The language", group,
    blocks: [
      text("Functions and conditions are written in a part of Python 3. A function is one or more statements, a condition one expression. There is no way to wait, to define functions, or to reach files and networks: so a function always ends, and does the same in every replay."),
      code("if par.width > 0.05:", "    svc.gripper.release(width=par.width)", "    var.tries += 1", "else:", "    print(f\"{par.width} m is too narrow\")"),
      list(
        "Values are `None`, `True`, `False`, whole numbers of 64 bit, floating-point numbers, texts, lists, and dicts whose keys are texts.",
        "`/` gives a floating-point number, `//` a whole one.",
        "An assignment copies: two names never mean the same list.",
        "`d.key` reads a dict like `d[\"key\"]`.",
        "What a function does takes effect when it is over: values, calls and prints. If something in it is unknown, nothing of it does.",
        "A call of an operation is a statement of its own; its answer is read in a later step.",
      ),
    ],
  },
  { id: "language-names", title: "Names of the model", group, blocks: [{ kind: "terms", terms: Object.entries(kCollections).map(([name, doc]) => ({ name, text: doc })) }] },
  {
    id: "language-words", title: "Words", group,
    blocks: [
      text(`In expressions: ${kExpressionKeywords.map((word) => `\`${word}\``).join(", ")}.`),
      text(`In functions besides: ${kStatementKeywords.map((word) => `\`${word}\``).join(", ")}.`),
      terms(["x if c else y", "x if c holds, else y"], ["[f for x in list if c]", "a list of f for each x of which c holds"], ["a < b < c", "both comparisons hold"]),
    ],
  },
  { id: "language-functions", title: "Functions", group, blocks: [text("An argument in brackets may be left out; one with `=` is given by its name."), functionsBlock([...kBuiltins, kAvailable])] },
  ...Object.entries(kModules).map(
    ([name, { doc, functions, constants }]): Topic => ({
      id: `language-${name}`, title: `Module ${name}`, group,
      blocks: [text(doc), ...(constants.length === 0 ? [] : [text(`Constants: ${constants.map((each) => `\`${name}.${each}\``).join(", ")}.`)]), functionsBlock(functions, `${name}.`)],
    }),
  ),
  {
    id: "language-methods", title: "Methods of texts, lists and dicts", group,
    blocks: [text("They do what they do in Python."), { kind: "heading", text: "Texts" }, methodsBlock(kTextMethods), { kind: "heading", text: "Lists" }, methodsBlock(kListMethods), { kind: "heading", text: "Dicts" }, methodsBlock(kDictMethods)],
  },
];
