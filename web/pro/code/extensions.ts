// What the editor of code is made of: keys, colours, completion, hover, and the marks of errors.
import { acceptCompletion, autocompletion, closeCompletion, completionKeymap, completionStatus } from "@codemirror/autocomplete";
import { defaultKeymap, history, historyKeymap, insertNewlineAndIndent } from "@codemirror/commands";
import { bracketMatching, indentService, indentUnit } from "@codemirror/language";
import { Compartment, EditorState, Prec, type Extension } from "@codemirror/state";
import { closeHoverTooltips, EditorView, hasHoverTooltips, hoverTooltip, keymap, placeholder as placeholderOf, tooltips, ViewPlugin } from "@codemirror/view";
import type { CodeFieldProps } from "./CodeField";
import { colours } from "./colours";
import { classOfOption, codeCompletions, codeHover, completes } from "./knowledge";
import { otherCursors } from "./otherCursors";
import { errorMarks } from "./marks";

/** How a field is shown. */
export type Options = Pick<CodeFieldProps, "label" | "describedBy" | "place" | "placeholder" | "multiline" | "readOnly">;

/** A line is indented as the one before it, and more behind a colon. */
const kIndent = "    ";
const indentation = indentService.of((context, position) => {
  const line = context.state.doc.lineAt(position);
  const before = line.number === 1 ? "" : context.state.doc.line(line.number - 1).text;
  const text = context.simulatedBreak === position ? line.text.slice(0, position - line.from) : before;
  return (/^ */.exec(text)?.[0].length ?? 0) + (/:\s*(#.*)?$/.test(text) ? kIndent.length : 0);
});

/** All but Enter, which takes a completion only if that changes the text. */
const kCompletionKeys = completionKeymap.filter(({ key }) => key !== "Enter");

/** Tab leads to the next field. With a completion open, it takes that, and Esc closes that alone. */
function keys(props: () => CodeFieldProps, multiline: boolean): Extension {
  const commitBy = (by: "key" | "enter") => (view: EditorView) => {
    closeCompletion(view);
    props().onCommit(by);
    return true;
  };
  const behindLine = multiline ? insertNewlineAndIndent : commitBy("enter");
  const complete = (view: EditorView) => completes(view.state) && acceptCompletion(view);
  const cancel = (view: EditorView) => completionStatus(view.state) === null && props().onCancel();
  return [
    Prec.high(keymap.of([{ key: "Mod-Enter", run: commitBy("key") }])),
    keymap.of([...kCompletionKeys, { key: "Tab", run: acceptCompletion }, { key: "Enter", run: complete }, { key: "Enter", run: behindLine }, { key: "Escape", run: cancel, stopPropagation: true }, ...historyKeymap, ...defaultKeymap]),
  ];
}

/** A text of one line stays one: line ends that are pasted become spaces. */
const oneLine = EditorState.transactionFilter.of((transaction) => {
  if (!transaction.docChanged || transaction.newDoc.lines === 1) return transaction;
  const insert = transaction.newDoc.toString().replace(/\s*\n\s*/g, " ");
  return { changes: { from: 0, to: transaction.startState.doc.length, insert }, selection: { anchor: Math.min(transaction.newSelection.main.head, insert.length) } };
});

/** What is typed over a selection is put there by the editor: the browser would keep the look of what was there by inline styles, which the page forbids. */
const typedOver = EditorView.domEventHandlers({
  beforeinput: (event, view) => {
    const isText = event.inputType === "insertText" && event.data !== null && !event.isComposing;
    const isDeletion = event.inputType.startsWith("deleteContent");
    if (view.state.readOnly || view.state.selection.main.empty || !(isText || isDeletion)) return false;
    event.preventDefault();
    const text = isText ? event.data : "";
    view.dispatch(view.state.replaceSelection(text), { userEvent: isText ? "input.type" : "delete", scrollIntoView: true });
    return true;
  },
});

let place: HTMLElement | undefined;

/** Where lists of completions and tips stand: over the page, in a landmark of its own. */
function hints(): HTMLElement {
  place ??= document.body.appendChild(Object.assign(document.createElement("aside"), { ariaLabel: "Hints of code" }));
  return place;
}

/** A tip is as wide as there is room right of the editor's edge, so that it covers nothing left of that; a press anywhere closes it. */
const hoverTips: Extension = [
  EditorView.domEventHandlers({
    mouseenter: (_, view) => document.documentElement.style.setProperty("--code-room", `${innerWidth - view.dom.getBoundingClientRect().left}px`),
  }),
  ViewPlugin.define((view) => {
    const press = () => hasHoverTooltips(view.state) && view.dispatch({ effects: closeHoverTooltips });
    addEventListener("pointerdown", press, true);
    return { destroy: () => removeEventListener("pointerdown", press, true) };
  }),
];

/** Completions that are still computed would open over what has the focus now. */
function leave(view: EditorView, props: () => CodeFieldProps): void {
  closeCompletion(view);
  props().onCommit("blur");
}

/** What may change while the editor is there. */
const shown = new Compartment();

function shownAs({ label, describedBy, place, placeholder, multiline, readOnly = false }: Options): Extension {
  const attributes = { "aria-label": label, "aria-multiline": String(multiline), spellcheck: "false", ...(describedBy !== undefined && { "aria-describedby": describedBy }), ...(place !== undefined && { "data-place": place }) };
  return [EditorView.contentAttributes.of(attributes), EditorState.readOnly.of(readOnly), ...(placeholder === undefined ? [] : [placeholderOf(placeholder)])];
}

/** Shows the field as it is to be now; the text, its selection and the focus stay. */
export const showAs = (view: EditorView, options: Options): void => view.dispatch({ effects: shown.reconfigure(shownAs(options)) });

/** `props`: the present ones, as what the editor calls may change while it is there. */
export function editorExtensions(props: () => CodeFieldProps): Extension {
  const { multiline } = props();
  return [
    keys(props, multiline),
    history(),
    bracketMatching(),
    indentUnit.of(kIndent),
    indentation,
    shown.of(shownAs(props())),
    EditorView.domEventHandlers({ blur: (_, view) => leave(view, props), focus: () => props().assistance?.prepare() }),
    hoverTips,
    typedOver,
    EditorView.lineWrapping,
    tooltips({ parent: hints(), position: "fixed" }),
    autocompletion({ override: [codeCompletions(props)], icons: false, defaultKeymap: false, optionClass: classOfOption }),
    hoverTooltip(codeHover(() => props().scope), { hoverTime: 250 }),
    colours,
    errorMarks,
    otherCursors,
    ...(multiline ? [] : [oneLine]),
  ];
}
