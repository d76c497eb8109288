// All that a person reads on the page stands in web/one/texts alone, so that another language is one more file.
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import ts from "typescript";
import { describe, expect, it } from "vitest";
import { en } from "../../one/texts/en";

const one = fileURLToPath(new URL("../../one", import.meta.url));
/** The entry shows nothing, and says only what nobody should ever read. */
const kWithout: ReadonlySet<string> = new Set(["main.tsx"]);

/** Attributes and properties whose value a person reads or hears. */
const kShown: ReadonlySet<string> = new Set(["aria-label", "aria-valuetext", "alt", "label", "placeholder", "title"]);
const hasWord = (text: string): boolean => /\p{L}{2}/u.test(text);
const isSentence = (text: string): boolean => /\p{L}\s+\p{L}/u.test(text);
/** `Start`, `Saving…`: a word as a person reads it, and not the name of a key. */
const isWord = (text: string): boolean => /^\p{Lu}\p{Ll}+[….]?$/u.test(text) && !["Enter", "Escape", "Delete"].includes(text);

type Text = ts.StringLiteralLike | ts.TemplateHead | ts.TemplateMiddle | ts.TemplateTail;
const isText = (node: ts.Node): node is Text => ts.isStringLiteralLike(node) || ts.isTemplateHead(node) || ts.isTemplateMiddle(node) || ts.isTemplateTail(node);

/** Names of classes, and what finds elements. */
function isOfCode(node: ts.Node): boolean {
  if (ts.isImportDeclaration(node)) return true;
  if (ts.isJsxAttribute(node)) return node.name.getText() === "className";
  if (ts.isVariableDeclaration(node)) return node.name.getText() === "looks";
  return ts.isCallExpression(node) && /(?:querySelector(?:All)?|closest|matches)(?:<.*>)?$/.test(node.expression.getText());
}

const kJoining: ReadonlySet<ts.SyntaxKind> = new Set([ts.SyntaxKind.BarBarToken, ts.SyntaxKind.QuestionQuestionToken, ts.SyntaxKind.PlusToken]);

/** What an expression that is shown comes to. */
function results(node: ts.Node): readonly ts.Node[] {
  if (ts.isParenthesizedExpression(node)) return results(node.expression);
  if (ts.isConditionalExpression(node)) return [...results(node.whenTrue), ...results(node.whenFalse)];
  if (ts.isBinaryExpression(node)) {
    const { kind } = node.operatorToken;
    if (kind === ts.SyntaxKind.AmpersandAmpersandToken) return results(node.right);
    return kJoining.has(kind) ? [...results(node.left), ...results(node.right)] : [];
  }
  if (ts.isTemplateExpression(node)) return [node.head, ...node.templateSpans.map(({ literal }) => literal)];
  return [node];
}

const isShown = ({ parent }: ts.JsxExpression): boolean => !ts.isJsxAttribute(parent) || kShown.has(parent.name.getText());

/** What a person would read in this code. */
function textsIn(code: string, file = "code.tsx"): readonly string[] {
  const found = new Set<string>();
  const visit = (node: ts.Node): void => {
    if (isOfCode(node)) return;
    if (ts.isJsxText(node) && hasWord(node.text)) found.add(node.text.trim());
    if (ts.isJsxAttribute(node) && kShown.has(node.name.getText()) && node.initializer !== undefined && ts.isStringLiteral(node.initializer) && hasWord(node.initializer.text)) found.add(node.initializer.text);
    if (ts.isJsxExpression(node) && node.expression !== undefined && isShown(node)) for (const each of results(node.expression)) if (isText(each) && hasWord(each.text)) found.add(each.text);
    if (isText(node) && (isSentence(node.text) || isWord(node.text))) found.add(node.text);
    ts.forEachChild(node, visit);
  };
  visit(ts.createSourceFile(file, code, ts.ScriptTarget.Latest, true));
  return [...found];
}

const files = readdirSync(one, { recursive: true, encoding: "utf8" }).filter((file) => /\.tsx?$/.test(file) && !file.startsWith("texts") && !kWithout.has(file));

/** All texts, those that are made of values with words for these. */
function leaves(value: unknown): readonly string[] {
  if (typeof value === "string") return [value];
  if (typeof value === "function") return [String((value as (...given: readonly string[]) => unknown)("1", "2", "3"))];
  return typeof value === "object" && value !== null ? Object.values(value).flatMap(leaves) : [];
}

describe("the texts of the page", () => {
  it("stand in no other file of web/one", () => {
    expect(files.length).toBeGreaterThan(50);
    expect(files.flatMap((file) => textsIn(readFileSync(join(one, file), "utf8"), file).map((text) => `${file}: ${text}`))).toEqual([]);
  });

  it("would be found in an element, an attribute, a constant, a choice and a template", () => {
    expect(textsIn("const a = <p>Go on</p>;")).toEqual(["Go on"]);
    expect(textsIn('const a = <p title="next" className="one two" />;')).toEqual(["next"]);
    expect(textsIn("const a = <p>{b ? 'Not now' : `Saved as ${c}`}</p>;")).toEqual(["Not now", "Saved as "]);
    expect(textsIn('const a = <p aria-label={b ? "more" : `less ${c}`}>{b && "off"}</p>;')).toEqual(["more", "less ", "off"]);
    expect(textsIn('const kNames = { start: "Start", saving: "Saving…" };')).toEqual(["Start", "Saving…"]);
    expect(textsIn('throw new Error("the server does not answer");')).toEqual(["the server does not answer"]);
    expect(textsIn('const a = { kind: "part", key: "Escape" }; document.querySelector(".skills input");')).toEqual([]);
    expect(textsIn('const a = <p className={`one ${b ? "two three" : ""}`} data-kind={b ? "part" : "place"} />;')).toEqual([]);
  });

  it("say something, in plain sentences: one or two for what is to be done", () => {
    expect(leaves(en).filter((text) => text.trim() === "")).toEqual([]);
    for (const step of ["cell", "camera", "part", "place", "application", "run"] as const) expect(en[step].todo.split(/[.!?](?:\s|$)/).filter((sentence) => sentence !== "").length, step).toBeLessThanOrEqual(2);
  });
});
