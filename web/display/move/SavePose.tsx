// Saves where the arm is, under a name.
import { useEffect, useId, useState } from "react";
import { freeName, isPoseName } from "../../shared/pendant/poses";
import { useRefusal } from "../client";
import { hand } from "./hand";

export function SavePose() {
  const refusal = useRefusal("call_service");
  const names = hand.usePoses((now) => now.names);
  const isLoaded = hand.usePoses((now) => now.isLoaded);
  useEffect(() => hand.poses.load(), []);
  const proposed = freeName(names);
  const [entry, setEntry] = useState<string>();
  const [said, setSaid] = useState<{ readonly text: string; readonly isBad: boolean }>();
  const [busy, setBusy] = useState(false);
  const hint = useId();
  const name = entry ?? proposed;
  const isName = isPoseName(name);
  const isTaken = names.includes(name);
  const save = async () => {
    setBusy(true);
    const problem = await hand.poses.save(name, isTaken);
    setBusy(false);
    setSaid(problem === undefined ? { text: `Saved as ${name}.`, isBad: false } : { text: `Not saved: ${problem}.`, isBad: true });
    if (problem === undefined) setEntry(undefined);
  };
  return (
    <form
      className="save-pose"
      aria-label="Save a pose"
      onSubmit={(event) => {
        event.preventDefault();
        if (isName && !busy && isLoaded && refusal === undefined) void save();
      }}
    >
      <input type="text" aria-label="Name of the pose" aria-describedby={hint} aria-invalid={!isName} maxLength={32} autoCapitalize="none" autoComplete="off" spellCheck={false} enterKeyHint="done" value={name} onChange={(event) => setEntry(event.target.value)} />
      <button type="submit" className="plain" disabled={!isName || busy || !isLoaded || refusal !== undefined} title={refusal}>
        {isTaken ? "Replace pose" : "Save pose"}
      </button>
      <p id={hint} role="status" className={said?.isBad === true || !isName ? "is-bad" : ""}>
        {isName ? (said?.text ?? (isTaken ? `${name} is there already: it will stand where the arm is now.` : "")) : "A name has letters, digits, _ or -, at most 32."}
      </p>
    </form>
  );
}
