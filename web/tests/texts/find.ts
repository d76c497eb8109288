// What a person would read in code, found in its syntax, and in style sheets; and all texts of a language.
import ts from "typescript";

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
export function textsIn(code: string, file = "code.tsx"): readonly string[] {
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

/** What a person would read that a style sheet puts before or behind elements. */
export const textsInStyles = (styles: string): readonly string[] => [...styles.matchAll(/[\s;{]content:[^;}]*?(["'])(.*?)\1/g)].map(([, , text = ""]) => text).filter(hasWord);

/** All texts, those that are made of values with words for these. */
export function leaves(value: unknown): readonly string[] {
  if (typeof value === "string") return [value];
  if (typeof value === "function") return [String((value as (...given: readonly string[]) => unknown)("1", "2", "3"))];
  return typeof value === "object" && value !== null ? Object.values(value).flatMap(leaves) : [];
}
