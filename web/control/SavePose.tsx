// Saves where the arm is: under a name that is free, the one that is given, or one that a person writes; also in place of the pose of that name.
import { useEffect, useId, useReducer, useState } from "react";
import { applySaving, kFirstSaving, shownSaving, type ShownSaving } from "../shared/pendant/saving";
import type { Hand } from "./hand";
import { texts } from "./texts";

interface Props {
  readonly hand: Hand;
  /** What free names begin with. */
  readonly stem?: string;
  /** The name, if there is no choice. */
  readonly fixed?: string | undefined;
  /** Whether a person may write the name. */
  readonly isNamed: boolean;
  readonly onSaved?: (name: string) => void;
}

function hintText(hint: ShownSaving["hint"], name: string): string {
  switch (hint?.type) {
    case undefined:
      return "";
    case "saved":
      return texts.poses.saved(hint.name);
    case "not_saved":
      return texts.poses.notSaved(hint.why);
    case "no_name":
      return texts.poses.noName;
    case "taken":
      return texts.poses.replaces(name);
  }
}

export function SavePose({ hand, stem, fixed, isNamed, onSaved }: Props) {
  const refusal = hand.useRefusal("call_service");
  const names = hand.usePoses((now) => now.names);
  const isLoaded = hand.usePoses((now) => now.isLoaded);
  useEffect(() => {
    hand.poses.load();
  }, [hand]);
  const [saving, dispatch] = useReducer(applySaving, kFirstSaving);
  const [busy, setBusy] = useState(false);
  const id = useId();
  const { name, isName, isTaken, button, hint, isBad } = shownSaving(saving, { names, stem, fixed, isNamed });
  const save = async () => {
    setBusy(true);
    const why = await hand.poses.save(name, isTaken);
    setBusy(false);
    dispatch(why === undefined ? { type: "saved", name } : { type: "not_saved", why });
    if (why === undefined) onSaved?.(name);
  };
  return (
    <form
      className="save-pose"
      aria-label={fixed === undefined ? texts.poses.save : texts.poses.saveNamed(fixed)}
      onSubmit={(event) => {
        event.preventDefault();
        if (isName && !busy && isLoaded && refusal === undefined) void save();
      }}
    >
      {isNamed && fixed === undefined && <input type="text" aria-label={texts.poses.name} aria-describedby={id} aria-invalid={!isName} maxLength={32} autoCapitalize="none" autoComplete="off" spellCheck={false} enterKeyHint="done" value={name} onChange={(event) => dispatch({ type: "written", entry: event.target.value })} />}
      <button type="submit" className={isNamed ? "plain" : "main"} disabled={!isName || busy || !isLoaded || refusal !== undefined} title={refusal}>
        {busy ? texts.poses.saving : texts.poses.button[button](name)}
      </button>
      <p id={id} role="status" className={isBad ? "is-bad" : ""}>
        {hintText(hint, name)}
      </p>
    </form>
  );
}
