// Completion and hover of the editor, from the scope of its text.
import type { Completion, CompletionContext, CompletionResult } from "@codemirror/autocomplete";
import type { EditorView, Tooltip } from "@codemirror/view";
import { completionAt, type CompletionItem } from "../../shared/code/completion";
import { hoverAt } from "../../shared/code/hover";
import type { Scope } from "../../shared/code/scope";

/** What belongs to the task stands before the words of the language. */
const kLanguage: ReadonlySet<string> = new Set(["function", "module", "keyword"]);

const optionOf = ({ name, insert, cursor, detail }: CompletionItem): Completion => ({
  label: name.name,
  detail,
  type: name.kind,
  boost: kLanguage.has(name.kind) ? 0 : 1,
  ...(name.doc !== undefined && { info: name.doc }),
  apply: (view: EditorView, _: Completion, from: number, to: number) => view.dispatch({ changes: { from, to, insert }, selection: { anchor: from + cursor }, userEvent: "input.complete" }),
});

export const codeCompletions =
  (scope: () => Scope) =>
  (context: CompletionContext): CompletionResult | null => {
    const found = completionAt(context.state.doc.toString(), context.pos, scope());
    if (found === undefined || (!found.isBegun && !context.explicit)) return null;
    return { from: found.from, options: found.items.map(optionOf), validFor: /^\w*$/ };
  };

export const codeHover =
  (scope: () => Scope) =>
  (view: EditorView, position: number): Tooltip | null => {
    const found = hoverAt(view.state.doc.toString(), position, scope());
    if (found === undefined) return null;
    const create = () => {
      const dom = document.createElement("div");
      dom.className = "code-hover";
      for (const [i, line] of found.lines.entries()) dom.appendChild(Object.assign(document.createElement(i === 0 ? "code" : "p"), { textContent: line }));
      return { dom };
    };
    return { pos: found.from, end: found.to, above: true, create };
  };
