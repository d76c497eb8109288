// The marks of errors: those of the server stay at their place while the text is typed, and names that mean nothing are found at once.
import { setDiagnostics, type Diagnostic } from "@codemirror/lint";
import { StateEffect, StateField, type Extension, type Text } from "@codemirror/state";
import { EditorView } from "@codemirror/view";
import { mistakesIn } from "../../shared/code/mistakes";
import type { Scope } from "../../shared/code/scope";
import type { CodeError } from "./CodeField";

const setErrors = StateEffect.define<readonly CodeError[]>();
const setScope = StateEffect.define<Scope>();

/** Where the error is: the word at its place; without a place, all of the text. Columns count characters from 1. */
function diagnosticOf(document: Text, { line = 0, column = 1, message }: CodeError): Diagnostic {
  if (line < 1 || line > document.lines) return { from: 0, to: document.length, severity: "error", message };
  const { from: start, text } = document.line(line);
  const before = Array.from(text).slice(0, column - 1).join("").length;
  const word = /^\w+|^\S/.exec(text.slice(before))?.[0].length ?? 0;
  const to = start + before + word;
  return { from: word === 0 ? Math.max(start, to - 1) : start + before, to, severity: "error", message };
}

const served = StateField.define<readonly Diagnostic[]>({
  create: () => [],
  update(before, { docChanged, changes, effects, newDoc }) {
    const told = effects.find((effect) => effect.is(setErrors));
    if (told !== undefined) return told.value.map((error) => diagnosticOf(newDoc, error));
    if (!docChanged) return before;
    return before.map((diagnostic) => ({ ...diagnostic, from: changes.mapPos(diagnostic.from, 1), to: changes.mapPos(diagnostic.to, -1) })).filter(({ from, to }) => from < to);
  },
});

const scope = StateField.define<Scope | undefined>({
  create: () => undefined,
  update: (before, { effects }) => effects.find((effect) => effect.is(setScope))?.value ?? before,
});

/** What the server has found stands before what is found here, once. */
function diagnostics(view: EditorView): readonly Diagnostic[] {
  const known = view.state.field(served);
  const names = view.state.field(scope);
  const found = names === undefined ? [] : mistakesIn(view.state.doc.toString(), names);
  return [...known, ...found.filter((mistake) => !known.some(({ from, to }) => from <= mistake.from && mistake.to <= to && to - from < view.state.doc.length))];
}

/** The word that is being written is not marked until it is whole. */
const kPause = 400;

export const errorMarks: Extension = [
  served,
  scope,
  EditorView.updateListener.of((update) => {
    const isNew = update.docChanged || update.transactions.some(({ effects }) => effects.some((effect) => effect.is(setErrors) || effect.is(setScope)));
    if (isNew) markSoon(update.view, update.docChanged ? kPause : 0);
  }),
];

const waiting = new WeakMap<EditorView, number>();

function markSoon(view: EditorView, pause: number): void {
  window.clearTimeout(waiting.get(view));
  const mark = () => {
    if (view.dom.isConnected) view.dispatch(setDiagnostics(view.state, [...diagnostics(view)]));
  };
  waiting.set(view, window.setTimeout(mark, pause));
}

/** The errors of the server in the text that is shown. */
export const showErrors = (view: EditorView, errors: readonly CodeError[]): void => view.dispatch({ effects: setErrors.of(errors) });

export const showScope = (view: EditorView, of: Scope): void => view.dispatch({ effects: setScope.of(of) });
