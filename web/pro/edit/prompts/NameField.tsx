// Asks a name where the element is. Enter takes it, and so does going elsewhere; Esc does not. A name that is none says why, and can be mended.
import { useEffect, useRef, useState, type KeyboardEvent } from "react";
import { endPrompt, isPrompting, leavePrompt, type Prompt } from "../prompt";

export function NameField({ prompt: { label, at, value, commit } }: { readonly prompt: Extract<Prompt, { readonly kind: "name" }> }) {
  const input = useRef<HTMLInputElement>(null);
  const [name, setName] = useState(value);
  const [reason, setReason] = useState<string>();
  useEffect(() => input.current?.select(), []);
  const take = () => {
    const why = commit(name);
    setReason(why);
    if (why === undefined) endPrompt();
  };
  const leave = () => {
    if (!isPrompting()) return;
    if (name !== value) commit(name);
    leavePrompt();
  };
  const press = (event: KeyboardEvent) => {
    event.stopPropagation();
    if (event.key === "Enter") take();
    else if (event.key === "Escape") endPrompt();
    else return;
    event.preventDefault();
  };
  return (
    <div className="name-field" style={{ left: Math.min(at.x, innerWidth - at.width - 8), top: Math.min(at.y, innerHeight - 60) }}>
      <input
        ref={input}
        autoFocus
        spellCheck={false}
        autoComplete="off"
        aria-label={label}
        aria-invalid={reason !== undefined}
        aria-describedby={reason === undefined ? undefined : "name-reason"}
        style={{ width: at.width }}
        value={name}
        onChange={(event) => setName(event.target.value)}
        onKeyDown={press}
        onBlur={leave}
      />
      {reason !== undefined && (
        <p id="name-reason" role="alert">
          {reason}
        </p>
      )}
    </div>
  );
}
