// Whether the condition of a port holds in the run, beside its field, while its state is active.
import { useEffect, useEffectEvent, useRef, useState } from "react";
import { entryOf } from "../../shared/json";
import { askableAddress, elementOfRun } from "../../shared/live/values";
import { portAddress } from "../../shared/model/model";
import { truthText } from "../../shared/run/whyText";
import type { Why } from "../../generated/messages";
import type { MicroStep } from "../../shared/derivation/proof";
import { whenText } from "../../shared/past/moment";
import type { RunSource } from "../../shared/api";
import { isStored } from "../../shared/session/session";
import { api, sourceOf, useSession } from "../client";
import { useEditing } from "../edit/editing";
import { useExecuted } from "./executed";
import { useShownRun } from "./shownRun";

/** The server is asked at most this often [ms]. */
const kEvery = 400;

/** The answer of the server for the state that is shown, asked for again when the run has gone on. */
function useTruth(source: RunSource, core: string | undefined, address: string | undefined, moment: unknown, past: MicroStep | undefined): Why["value"] | undefined {
  const [truth, setTruth] = useState<{ readonly of: string; readonly value: Why["value"] }>();
  const key = core === undefined || address === undefined ? undefined : `${source} ${core} ${address}`;
  const askedRef = useRef(0);
  const ask = useEffectEvent(() => {
    if (core === undefined || address === undefined || key === undefined) return;
    askedRef.current = performance.now();
    // A state that has been left meanwhile has nothing to say.
    api.why(source, core, address, past).then(({ value }) => setTruth({ of: key, value }), () => setTruth(undefined));
  });
  useEffect(() => {
    if (key === undefined) return;
    const timer = setTimeout(ask, Math.max(0, askedRef.current + kEvery - performance.now()));
    return () => clearTimeout(timer);
  }, [key, moment]);
  return truth?.of === key ? truth?.value : undefined;
}

export function ConditionNow({ id }: { readonly id: string }) {
  const core = useShownRun((shown) => shown.core);
  const run = useShownRun((shown) => shown.run);
  const address = useShownRun(({ tree, run: now }) => askableAddress(tree, now, id));
  const isFired = useShownRun(({ tree, run: now }) => {
    const found = elementOfRun(tree, id);
    return found?.kind === "port" && now.ports.includes(portAddress(found.path, found.element));
  });
  const past = useSession((s) => s.past?.past);
  const stored = useSession(isStored);
  const truth = useTruth(useSession(sourceOf), core?.id, address, run, past);
  const edited = useEditing(({ session }) => session?.view?.elements.get(id)?.fields);
  const executed = useExecuted();
  if (core === undefined) return null;
  if (isFired === true) return <p className="row-now">has fired</p>;
  if (truth === undefined) return null;
  const before = executed === undefined || "reason" in executed ? undefined : executed.elements.get(id)?.fields;
  const isOther = before !== undefined && (entryOf(before, "when") !== entryOf(edited, "when") || entryOf(before, "after") !== entryOf(edited, "after"));
  return (
    <p className="row-now">
      {isOther && `in revision ${core.revision}, `}
      {`${whenText(past, stored)}: ${truthText(truth)}`}
    </p>
  );
}
