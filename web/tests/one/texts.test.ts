// The texts of the guide and of teaching stand in web/one/texts alone, so that another language is one more file.
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import ts from "typescript";
import { describe, expect, it } from "vitest";
import { en } from "../../one/texts/en";

const kFolders = ["guide", "teach"] as const;
const one = fileURLToPath(new URL("../../one", import.meta.url));

/** Attributes whose value a person reads or hears. */
const kShown: ReadonlySet<string> = new Set(["aria-label", "alt", "label", "placeholder", "title"]);
const hasWord = (text: string): boolean => /\p{L}{2}/u.test(text);
const isSentence = (text: string): boolean => /\p{L}\s+\p{L}/u.test(text);

/** What a person would read in this code. */
function textsIn(code: string): readonly string[] {
  const found: string[] = [];
  const visit = (node: ts.Node): void => {
    if (ts.isJsxText(node) && hasWord(node.text)) found.push(node.text.trim());
    if (ts.isJsxAttribute(node)) {
      const name = node.name.getText();
      if (name === "className") return;
      if (kShown.has(name) && node.initializer !== undefined && ts.isStringLiteral(node.initializer) && hasWord(node.initializer.text)) found.push(node.initializer.text);
    } else if ((ts.isStringLiteralLike(node) || ts.isTemplateHead(node) || ts.isTemplateMiddle(node) || ts.isTemplateTail(node)) && (isSentence(node.text) || (ts.isJsxExpression(node.parent) && hasWord(node.text)))) found.push(node.text);
    ts.forEachChild(node, visit);
  };
  visit(ts.createSourceFile("code.tsx", code, ts.ScriptTarget.Latest, true, ts.ScriptKind.TSX));
  return found;
}

/** All texts, those that are made of values with words for these. */
function leaves(value: unknown): readonly string[] {
  if (typeof value === "string") return [value];
  if (typeof value === "function") return [String((value as (...given: readonly string[]) => unknown)("1", "2", "3"))];
  return typeof value === "object" && value !== null ? Object.values(value).flatMap(leaves) : [];
}

describe("the texts of the guide", () => {
  it.each(kFolders)("stand nowhere in one/%s", (folder) => {
    const files = readdirSync(join(one, folder));
    expect(files.length).toBeGreaterThan(1);
    expect(files.flatMap((file) => textsIn(readFileSync(join(one, folder, file), "utf8")).map((text) => `${file}: ${text}`))).toEqual([]);
  });

  it("would be found in an element, an attribute, a constant and a template", () => {
    expect(textsIn("const a = <p>Go on</p>;")).toEqual(["Go on"]);
    expect(textsIn('const a = <p title="Next" className="one two" />;')).toEqual(["Next"]);
    expect(textsIn("const a = <p>{b ? 'Not now' : `Saved as ${c}`}</p>;")).toEqual(["Not now", "Saved as "]);
    expect(textsIn('const a = <p>{"Next"}</p>;')).toEqual(["Next"]);
    expect(textsIn('const a = { kind: "part" };')).toEqual([]);
  });

  it("say something, in plain sentences: one or two for what is to be done", () => {
    expect(leaves(en).filter((text) => text.trim() === "")).toEqual([]);
    for (const step of ["cell", "camera", "part", "place", "application", "run"] as const) expect(en[step].todo.split(/[.!?](?:\s|$)/).filter((sentence) => sentence !== "").length, step).toBeLessThanOrEqual(2);
  });
});
