// The editor of a text of code. CodeMirror holds the text; what it is told and tells goes through here.
import { useEffect, useRef } from "react";
import { Annotation } from "@codemirror/state";
import { EditorView } from "@codemirror/view";
import { adoptStyles } from "./adoptStyles";
import type { CodeFieldProps } from "./CodeField";
import { registerCursor } from "./cursor";
import { editorExtensions, showAs } from "./extensions";
import { showErrors, showScope } from "./marks";
import { showCursors } from "./otherCursors";

adoptStyles();

/** A change that comes from the page, not from a person's hand. */
const isTold = Annotation.define<true>();

export default function CodeEditor(props: CodeFieldProps) {
  const host = useRef<HTMLDivElement>(null);
  const editor = useRef<EditorView>(undefined);
  const latest = useRef(props);
  useEffect(() => {
    latest.current = props;
  });
  const { value, scope, errors, cursors, label, describedBy, place, placeholder, multiline, readOnly = false } = props;

  useEffect(() => {
    if (host.current === null) return undefined;
    const view = new EditorView({
      parent: host.current,
      doc: latest.current.value,
      extensions: [
        editorExtensions(() => latest.current),
        EditorView.updateListener.of((update) => {
          const isOwn = update.transactions.every((transaction) => transaction.annotation(isTold) !== true);
          if (update.docChanged && isOwn) latest.current.onChange(update.state.doc.toString());
          if (update.selectionSet || update.docChanged || update.focusChanged) latest.current.onCursor(update.view.hasFocus ? update.state.selection.main.head : undefined);
        }),
      ],
    });
    editor.current = view;
    registerCursor(view.contentDOM, {
      text: () => view.state.doc.toString(),
      position: () => view.state.selection.main.head,
      select: ({ from, to }) => {
        const end = view.state.doc.length;
        view.dispatch({ selection: { anchor: Math.min(from, end), head: Math.min(to, end) }, scrollIntoView: true });
      },
    });
    showScope(view, latest.current.scope);
    showErrors(view, latest.current.errors);
    showCursors(view, latest.current.cursors);
    return () => {
      latest.current.onCursor(undefined);
      view.destroy();
    };
  }, []);

  useEffect(() => {
    if (editor.current !== undefined) showAs(editor.current, { label, describedBy, place, placeholder, multiline, readOnly });
  }, [label, describedBy, place, placeholder, multiline, readOnly]);

  useEffect(() => {
    const view = editor.current;
    if (view === undefined || view.state.doc.toString() === value) return;
    view.dispatch({ changes: { from: 0, to: view.state.doc.length, insert: value }, annotations: isTold.of(true) });
  }, [value]);
  useEffect(() => {
    if (editor.current !== undefined) showScope(editor.current, scope);
  }, [scope]);
  useEffect(() => {
    if (editor.current !== undefined) showErrors(editor.current, errors);
  }, [errors]);
  useEffect(() => {
    if (editor.current !== undefined) showCursors(editor.current, cursors);
  }, [cursors]);
  return <div ref={host} className="code-editor" />;
}
