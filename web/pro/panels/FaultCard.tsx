// A fault: what it was, at which state, where in its code, and what led there.
import { useMemo } from "react";
import type { Core, Fault } from "../../generated/messages";
import { faultCauses, faultPlaces, type CodePlace } from "../../shared/run/faultCauses";
import type { Selection } from "../../shared/model/identity";
import { inputText } from "../../shared/run/inputText";
import { ownerOf, type ModelTree } from "../../shared/model/modelTree";
import { selectionAt } from "../../shared/session/view";
import { useSession, view } from "../client";
import { CauseList } from "./CauseList";
import { showInput } from "./showInput";

/** More than so many places say nothing. */
const kMostPlaces = 6;

interface Props {
  readonly core: Core;
  readonly fault: Fault;
  readonly tree: ModelTree | undefined;
}

export function FaultCard({ core, fault, tree }: Props) {
  const steps = useSession((s) => s.steps);
  const last = useSession((s) => s.steps.find(({ step }) => step === core.step)?.input ?? s.lastInput);
  const isActive = useSession((s) => s.run?.active.includes(fault.at) === true);
  const selection = useMemo((): Selection => (tree && selectionAt(tree, fault.at)) ?? { kind: "node", path: fault.at }, [tree, fault.at]);
  const state = selection.kind === "port" ? ownerOf(selection.address) : selection.path;
  const chain = useMemo(() => (tree === undefined ? [] : faultCauses(tree, steps, state)), [tree, steps, state]);
  const places = useMemo(() => (tree === undefined ? [] : faultPlaces(tree, fault, isActive)), [tree, fault, isActive]);
  return (
    <section className="fault" aria-label="Fault">
      <h3>Fault: {fault.kind}</h3>
      <p>{fault.message}</p>
      <button type="button" className="link" onClick={() => view.dispatch({ type: "jump", selection })}>
        at {fault.at}
      </button>{" "}
      <button type="button" className="link" onClick={() => showInput(core.step)}>
        in macro step {core.step}
        {last !== undefined && (
          <>
            , upon <code>{inputText(last)}</code>
          </>
        )}
      </button>
      {places.length > 0 && places.length <= kMostPlaces && <Places places={places} isActive={isActive} />}
      {chain.length > 0 && <h4>The state was entered by</h4>}
      <CauseList chain={chain} />
    </section>
  );
}

function Places({ places, isActive }: { readonly places: readonly CodePlace[]; readonly isActive: boolean }) {
  return (
    <>
      <h4>
        {places.length > 1 ? "In one of these, evaluated" : "In its code, evaluated"} {isActive ? "while it is active" : "as it is entered"}
      </h4>
      <ul aria-label="Places in the code">
        {places.map(({ part, text, selection }, i) => (
          <li key={i}>
            <button type="button" className="link" onClick={() => view.dispatch({ type: "jump", selection })}>
              {part} <code>{text}</code>
            </button>
          </li>
        ))}
      </ul>
    </>
  );
}
