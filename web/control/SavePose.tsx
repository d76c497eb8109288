// Saves where the arm is, under a name that is free; or under one that a person writes, also in place of the pose of that name.
import { useEffect, useId, useState } from "react";
import { freeName, isPoseName } from "../shared/pendant/poses";
import type { Hand } from "./hand";

interface Props {
  readonly hand: Hand;
  /** What free names begin with. */
  readonly stem?: string;
  /** Whether a person may write the name. */
  readonly isNamed: boolean;
  readonly onSaved?: (name: string) => void;
}

export function SavePose({ hand, stem, isNamed, onSaved }: Props) {
  const refusal = hand.useRefusal("call_service");
  const names = hand.usePoses((now) => now.names);
  const isLoaded = hand.usePoses((now) => now.isLoaded);
  useEffect(() => hand.poses.load(), [hand]);
  const [entry, setEntry] = useState<string>();
  const [said, setSaid] = useState<{ readonly text: string; readonly isBad: boolean }>();
  const [busy, setBusy] = useState(false);
  const hint = useId();
  const name = entry ?? freeName(names, stem);
  const isName = isPoseName(name);
  const isTaken = names.includes(name);
  const save = async () => {
    setBusy(true);
    const problem = await hand.poses.save(name, isTaken);
    setBusy(false);
    setSaid(problem === undefined ? { text: `Saved as ${name}.`, isBad: false } : { text: `Not saved: ${problem}. Try again.`, isBad: true });
    if (problem !== undefined) return;
    setEntry(undefined);
    onSaved?.(name);
  };
  const label = !isNamed ? `Save as ${name}` : isTaken ? "Replace pose" : "Save pose";
  const taken = isTaken ? `${name} is there already: it will stand where the arm is now.` : "";
  return (
    <form
      className="save-pose"
      aria-label="Save a pose"
      onSubmit={(event) => {
        event.preventDefault();
        if (isName && !busy && isLoaded && refusal === undefined) void save();
      }}
    >
      {isNamed && <input type="text" aria-label="Name of the pose" aria-describedby={hint} aria-invalid={!isName} maxLength={32} autoCapitalize="none" autoComplete="off" spellCheck={false} enterKeyHint="done" value={name} onChange={(event) => setEntry(event.target.value)} />}
      <button type="submit" className={isNamed ? "plain" : "main"} disabled={!isName || busy || !isLoaded || refusal !== undefined} title={refusal}>
        {busy ? "Saving…" : label}
      </button>
      <p id={hint} role="status" className={said?.isBad === true || !isName ? "is-bad" : ""}>
        {isName ? (said?.text ?? taken) : "A name has letters, digits, _ or -, at most 32."}
      </p>
    </form>
  );
}
