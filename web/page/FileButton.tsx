// A button that asks for JSON files. The input behind it has a name of its own, and takes the same file again.
import { useRef, type ReactNode } from "react";

interface Props {
  readonly children: ReactNode;
  /** Of the input. */
  readonly name: string;
  readonly multiple?: boolean;
  readonly disabled?: boolean;
  readonly title?: string;
  readonly onFiles: (files: readonly File[]) => void;
}

export function FileButton({ children, name, multiple = false, disabled = false, title, onFiles }: Props) {
  const input = useRef<HTMLInputElement>(null);
  return (
    <>
      <button type="button" disabled={disabled} title={title} onClick={() => input.current?.click()}>
        {children}
      </button>
      <input
        ref={input}
        type="file"
        hidden
        multiple={multiple}
        accept=".json,application/json"
        aria-label={name}
        onChange={({ target }) => {
          onFiles([...(target.files ?? [])]);
          target.value = "";
        }}
      />
    </>
  );
}
