// Puts the cell back to how it was at the start; asked in place, as it takes back what tasks have done.
import { useEffect, useRef, useState } from "react";
import { refusalToReset } from "../../shared/cell/reset";
import { messageOf } from "../../shared/messageOf";
import { api, useSession } from "../client";
import { useRefusal } from "../login/rights";
import { CellTool } from "./CellTool";
import { askReset, useResetAsked } from "./reset";

export function ResetCell() {
  const [database, setDatabase] = useState(true);
  const [busy, setBusy] = useState(false);
  const [refused, setRefused] = useState<string>();
  const refusal = useSession((s) => refusalToReset(s.cores));
  const first = useRef<HTMLButtonElement>(null);
  useEffect(() => first.current?.focus(), []);
  const reset = async () => {
    setBusy(true);
    setRefused(undefined);
    try {
      await api.resetCell(database);
      askReset(false);
    } catch (error) {
      setRefused(messageOf(error));
    } finally {
      setBusy(false);
    }
  };
  const reason = refused ?? refusal;
  return (
    <div
      className="cell-reset"
      role="group"
      aria-label="Reset the cell?"
      onPointerDown={(event) => event.stopPropagation()}
      onKeyDown={(event) => {
        if (event.key !== "Escape") return;
        event.preventDefault();
        event.stopPropagation();
        askReset(false);
      }}
    >
      <p>Reset the cell? Parts and robot are at once where they were at the start, and hands let go.</p>
      <label>
        <input type="checkbox" checked={database} onChange={(event) => setDatabase(event.target.checked)} />
        Reset the database, too: values that tasks have stored are lost.
      </label>
      {reason !== undefined && <p role="alert">Not done: {reason}.</p>}
      <div>
        <button type="button" className="danger" disabled={busy || refusal !== undefined} onClick={() => void reset()}>
          Reset
        </button>
        <button type="button" ref={first} onClick={() => askReset(false)}>
          Keep it
        </button>
      </div>
    </div>
  );
}

export function ResetButton({ disabled }: { readonly disabled: boolean }) {
  const asked = useResetAsked();
  const refusal = useRefusal("reset_cell");
  return (
    <CellTool name="Reset demo" icon="again" hint={refusal ?? "parts, robot and database as at the start"} disabled={disabled || refusal !== undefined} aria-expanded={asked} onClick={() => askReset(!asked)} />
  );
}
