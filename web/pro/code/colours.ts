// The colours of a text: a class for each kind of token (styles/code.css).
import { RangeSetBuilder, type Text } from "@codemirror/state";
import { Decoration, ViewPlugin, type DecorationSet, type ViewUpdate } from "@codemirror/view";
import { fieldsOf } from "../../shared/code/strings";
import { tokensOf, type Token } from "../../shared/code/tokens";
import { isCollection, kBuiltins, kModules } from "../../shared/code/words";

const kFunctions: ReadonlySet<string> = new Set([...kBuiltins.map(({ name }) => name), "available", ...Object.keys(kModules)]);

const marks = Object.fromEntries(["keyword", "string", "number", "comment", "call", "scope", "wrong"].map((name) => [name, Decoration.mark({ class: `code-${name}` })]));

function markOf({ kind, text }: Token, isAttribute: boolean): Decoration | undefined {
  if (kind !== "name") return marks[kind];
  if (isAttribute) return undefined;
  return isCollection(text) ? marks["scope"] : kFunctions.has(text) ? marks["call"] : undefined;
}

/** The pieces of a text string between its expressions, and those. */
function pieces(text: string, token: Token): readonly Token[] {
  if (token.kind !== "string") return [token];
  const fields = fieldsOf(text, token);
  const ends = [token.from, ...fields.map(({ to }) => to)];
  const inner = (i: number) => (fields[i] === undefined ? [] : tokensOf(text, fields[i].from, fields[i].to));
  return ends.flatMap((from, i) => [{ ...token, from, to: Math.max(from, fields[i]?.from ?? token.to) }, ...inner(i)]);
}

function decorate(document: Text): DecorationSet {
  const text = document.toString();
  const builder = new RangeSetBuilder<Decoration>();
  let previous: Token | undefined;
  for (const token of tokensOf(text).flatMap((each) => pieces(text, each))) {
    const mark = markOf(token, previous?.kind === "operator" && previous.text === ".");
    if (mark !== undefined && token.from < token.to) builder.add(token.from, token.to, mark);
    previous = token;
  }
  return builder.finish();
}

export const colours = ViewPlugin.define(
  (view) => ({
    decorations: decorate(view.state.doc),
    update(update: ViewUpdate) {
      if (update.docChanged) this.decorations = decorate(update.state.doc);
    },
  }),
  { decorations: (plugin) => plugin.decorations },
);
