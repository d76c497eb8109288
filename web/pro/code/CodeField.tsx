// A field for a text of code. The editor comes with its own bundle; until that is there, and where it cannot be loaded, it is a plain text area.
import { lazy, Suspense } from "react";
import type { Scope } from "../../shared/code/scope";
import { EditorBoundary } from "./EditorBoundary";

/** An error of the server in the text that the document has; without line: of the text as a whole. */
export interface CodeError {
  readonly line?: number;
  readonly column?: number;
  readonly message: string;
}

/** Which operations no service can accept there (`svc.key.operation`), and why. */
export interface Assistance {
  /** The field has the focus: it may be asked soon. */
  readonly prepare: () => void;
  /** `before`: the text in front of the place. */
  readonly unreachable: (before: string) => Promise<ReadonlyMap<string, string>>;
}

/** Where somebody else writes in the text. */
export interface OtherCursor {
  readonly id: number;
  readonly name: string;
  readonly colour: number;
  /** In UTF-16 units. */
  readonly offset: number;
}

export interface CodeFieldProps {
  readonly value: string;
  readonly onChange: (value: string) => void;
  /** Ctrl+Enter (`key`); Enter, if the text has one line; or the field is left (`blur`). */
  readonly onCommit: (by: "key" | "enter" | "blur") => void;
  /** Esc, when nothing is open that it would close; whether it meant something, so that the page does not hear it. */
  readonly onCancel: () => boolean;
  /** Where the cursor is; nothing: the field has been left. */
  readonly onCursor: (offset: number | undefined) => void;
  readonly label: string;
  /** Of the element that describes the field. */
  readonly describedBy?: string | undefined;
  /** `data-place`: by it the field is found. */
  readonly place?: string | undefined;
  readonly placeholder?: string | undefined;
  readonly scope: Scope;
  /** Where operations are called. */
  readonly assistance?: Assistance | undefined;
  readonly errors: readonly CodeError[];
  readonly cursors: readonly OtherCursor[];
  readonly multiline: boolean;
  readonly readOnly?: boolean;
}

/** Loads the editor ahead, so that no field changes under the hand that writes in it. */
export const loadCodeEditor = () => import("./CodeEditor");

const CodeEditor = lazy(loadCodeEditor);

export function CodeField(props: CodeFieldProps) {
  const plain = <PlainField {...props} />;
  return (
    <div className={`code-field${props.multiline ? "" : " is-line"}`}>
      <EditorBoundary fallback={plain}>
        <Suspense fallback={plain}>
          <CodeEditor {...props} />
        </Suspense>
      </EditorBoundary>
    </div>
  );
}

function PlainField({ value, onChange, onCommit, onCancel, onCursor, label, describedBy, place, placeholder, multiline, readOnly = false }: CodeFieldProps) {
  return (
    <textarea
      aria-label={label}
      aria-describedby={describedBy}
      data-place={place}
      placeholder={placeholder}
      rows={multiline ? value.split("\n").length : 1}
      value={value}
      readOnly={readOnly}
      spellCheck={false}
      onChange={(event) => onChange(event.target.value)}
      onSelect={({ currentTarget }) => onCursor(currentTarget.selectionStart)}
      onBlur={() => {
        onCursor(undefined);
        onCommit("blur");
      }}
      onKeyDown={(event) => {
        if (event.key === "Escape" && onCancel()) event.stopPropagation();
        if (event.key !== "Enter" || (multiline && !event.ctrlKey && !event.metaKey)) return;
        event.preventDefault();
        onCommit(event.ctrlKey || event.metaKey ? "key" : "enter");
      }}
    />
  );
}
