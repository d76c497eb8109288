// A field for a text of code. The editor comes with its own bundle; until that is there, and where it cannot be loaded, it is a plain text area.
import { useEffect, useRef, useState, type ComponentType } from "react";
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

let loaded: ComponentType<CodeFieldProps> | undefined;

/** Loads the editor, ahead of the first field. */
export async function loadCodeEditor(): Promise<void> {
  loaded ??= (await import("./CodeEditor")).default;
}

export function CodeField(props: CodeFieldProps) {
  const field = useRef<HTMLDivElement>(null);
  const [Editor, setEditor] = useState(() => loaded);
  useEffect(() => {
    if (Editor !== undefined) return undefined;
    let isThere = true;
    // A field does not change under the hand that writes in it: it is left first.
    const take = () => {
      const isWrittenIn = field.current?.contains(document.activeElement) === true;
      if (isThere && !isWrittenIn && loaded !== undefined) setEditor(() => loaded);
    };
    const left = () => setTimeout(take);
    const place = field.current;
    place?.addEventListener("focusout", left);
    void loadCodeEditor().then(take, () => undefined);
    return () => {
      isThere = false;
      place?.removeEventListener("focusout", left);
    };
  }, [Editor]);
  const plain = <PlainField {...props} />;
  return (
    <div ref={field} className={`code-field${props.multiline ? "" : " is-line"}`}>
      {Editor === undefined ? (
        plain
      ) : (
        <EditorBoundary fallback={plain}>
          <Editor {...props} />
        </EditorBoundary>
      )}
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
