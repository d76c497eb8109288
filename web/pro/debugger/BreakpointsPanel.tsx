// All breakpoints of the person here at the document: where, when, with which condition, and whether the watched run has them.
import { useMemo } from "react";
import { enabledOf, kMostBreakpoints, type Entry } from "../../shared/debugger/breakpoints";
import { missingOn } from "../../shared/debugger/onCore";
import type { ModelTree } from "../../shared/model/modelTree";
import { isOver } from "../../shared/run/controls";
import { attempt, useCore } from "../client";
import { ask } from "../edit/prompt";
import { keysOf } from "../../shared/session/shortcuts";
import { useRefusal } from "../login/rights";
import { commandOf, menuEntryOf } from "./actions";
import { BreakpointRow } from "./BreakpointRow";
import { armCore } from "./breakpoints";
import { useKept } from "./kept";

const kAdded = ["breakpoint", "breakpoint_kind", "breakpoint_any_called", "breakpoint_any_fault"];

function openAdd(button: HTMLElement): void {
  const { left, bottom } = button.getBoundingClientRect();
  ask({ kind: "menu", label: "Add a breakpoint", at: { x: left, y: bottom }, entries: kAdded.map((id) => menuEntryOf(commandOf(id))) });
}

export function BreakpointsPanel({ tree }: { readonly tree: ModelTree | undefined }) {
  const entries = useKept((kept) => kept.entries);
  const loaded = useKept((kept) => kept.loaded);
  const unkept = useKept((kept) => kept.unkept);
  const refusal = useRefusal("set_breakpoints");
  if (!loaded) return null;
  return (
    <section className="breakpoints" aria-label="Breakpoints">
      <header>
        <h2>
          Breakpoints{entries.length > 0 && <small> {entries.length}</small>}
        </h2>
        <button type="button" className="row-add" aria-label="Add a breakpoint" title={refusal ?? "Add a breakpoint"} aria-haspopup="menu" disabled={refusal !== undefined || entries.length >= kMostBreakpoints} onClick={({ currentTarget }) => openAdd(currentTarget)}>
          +
        </button>
      </header>
      {entries.length === 0 ? (
        refusal === undefined && <p className="quiet">Select a state or port and press {keysOf("breakpoint")}, or click it with the right button.</p>
      ) : (
        <ul aria-label="Breakpoints">
          {entries.map((entry) => (
            <BreakpointRow key={entry.number} entry={entry} tree={tree} />
          ))}
        </ul>
      )}
      {unkept !== undefined && <p className="breakpoint-error" role="alert">Not kept: {unkept}</p>}
      <NotOnCore entries={entries} />
    </section>
  );
}

/** A run that this page has not let go since has only what it was given. */
function NotOnCore({ entries }: { readonly entries: readonly Entry[] }) {
  const core = useCore();
  const of = useKept((kept) => kept.of);
  const refused = useKept((kept) => kept.refused);
  const missing = useMemo(() => (core === undefined || of === undefined ? [] : missingOn(core, of.author, enabledOf(entries))), [core, of, entries]);
  if (core === undefined || core.document !== of?.document || isOver(core) || core.status === "ready" || missing.length <= refused.size) return null;
  return (
    <p className="quiet">
      {missing.length === 1 ? "One is" : `${missing.length} are`} not in run {core.id}.{" "}
      <button type="button" className="link" onClick={() => void attempt(() => armCore(core))}>
        Set {missing.length === 1 ? "it" : "them"} there
      </button>
    </p>
  );
}
