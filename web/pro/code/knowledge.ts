// Completion and hover of the editor, from the scope of its text.
import { selectedCompletion, type Completion, type CompletionContext, type CompletionResult, type CompletionSection } from "@codemirror/autocomplete";
import type { EditorState } from "@codemirror/state";
import type { EditorView, Tooltip } from "@codemirror/view";
import { completionAt, marked, offersOperations, type Completion as Found, type CompletionItem } from "../../shared/code/completion";
import { hoverAt } from "../../shared/code/hover";
import type { Scope } from "../../shared/code/scope";
import type { CodeFieldProps } from "./CodeField";

/** What belongs to the task stands before the words of the language. */
const kLanguage: ReadonlySet<string> = new Set(["function", "module", "keyword"]);

/** What an option is made of. */
const items = new WeakMap<Completion, CompletionItem>();

/** Below all others. */
const kUnreachable: CompletionSection = {
  name: "Not accepted here",
  rank: 1,
  header: ({ name }) => Object.assign(document.createElement("completion-section"), { textContent: name, role: "presentation" }),
};

function optionOf(item: CompletionItem): Completion {
  const { name, insert, cursor, detail, against } = item;
  const option: Completion = {
    label: name.name,
    detail: against ?? detail,
    type: name.kind,
    boost: kLanguage.has(name.kind) ? 0 : 1,
    ...(name.doc !== undefined && { info: name.doc }),
    ...(against !== undefined && { section: kUnreachable }),
    apply: (view: EditorView, _: Completion, from: number, to: number) => view.dispatch({ changes: { from, to, insert }, selection: { anchor: from + cursor }, userEvent: "input.complete" }),
  };
  items.set(option, item);
  return option;
}

/** An operation that no service can accept is struck through. */
export const classOfOption = (option: Completion): string => (items.get(option)?.against === undefined ? "" : "is-unreachable");

/** Whether taking the selected option would change the text. */
export function completes(state: EditorState): boolean {
  const option = selectedCompletion(state);
  const item = option === null ? undefined : items.get(option);
  const { head } = state.selection.main;
  const line = state.doc.lineAt(head);
  const word = /\w*$/.exec(line.text.slice(0, head - line.from))?.[0];
  return item !== undefined && item.insert !== word;
}

const resultOf = ({ from, items: offered }: Found): CompletionResult => ({ from, options: offered.map(optionOf), validFor: /^\w*$/ });

/** Where operations are offered it is asked which of them can be accepted; one types on meanwhile. */
export const codeCompletions =
  (props: () => Pick<CodeFieldProps, "scope" | "assistance">) =>
  (context: CompletionContext): CompletionResult | Promise<CompletionResult> | null => {
    const { scope, assistance } = props();
    const text = context.state.doc.toString();
    const found = completionAt(text, context.pos, scope);
    if (found === undefined || (!found.isBegun && !context.explicit)) return null;
    if (assistance === undefined || !offersOperations(found)) return resultOf(found);
    return assistance.unreachable(text.slice(0, found.from)).then((unreachable) => resultOf(marked(found, unreachable)));
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
