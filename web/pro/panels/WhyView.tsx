// Why a port fires or an action is executed, or not: the atoms of its condition with their values, and those whose change would do it. What a
// parameter is given, and what its expression reads.
import type { Why, WhyParameter } from "../../generated/messages";
import { openCallsOf } from "../../shared/run/openCalls";
import { awaitedTexts } from "../../shared/run/awaited";
import { portsRead } from "../../shared/run/portsRead";
import { atomAdvice, isDone, namesText, parameterHeadline, readsText, truthText, whyHeadline, whySentences, type WhyCondition } from "../../shared/run/whyText";
import { splitAddress } from "../../shared/model/modelTree";
import { useCore, useSession, view } from "../client";
import { useRunTree } from "../live/runTree";
import { CodeText } from "./CodeText";
import { useCellTime } from "./useCellTime";
import { useHeld } from "./useHeld";

interface Props {
  readonly why: Why;
  /** The moment that it is about, such as `now`. */
  readonly when: string;
}

export function WhyView({ why, when }: Props) {
  return "reads" in why ? <ParameterView why={why} when={when} /> : <ConditionView why={why} when={when} />;
}

/** Within a macro step, an explanation is about the turn in the next micro step, which may come after other changes. */
const momentOfWhy = ({ turn }: Why, when: string): string => (turn === true ? `${when}, when its turn comes in the next micro step` : when);

function ConditionView({ why, when }: { readonly why: WhyCondition; readonly when: string }) {
  const waits = useAwaited(why);
  return (
    <section className="why" aria-label="Why">
      <h3>{whyHeadline(why)}</h3>
      {whySentences(why).map((sentence) => (
        <p key={sentence}>
          <CodeText text={sentence} />
        </p>
      ))}
      <Atoms why={why} waits={waits} />
      <p className="quiet">
        Condition {momentOfWhy(why, when)}: <strong>{truthText(why.value)}</strong>
      </p>
    </section>
  );
}

function ParameterView({ why, when }: { readonly why: WhyParameter; readonly when: string }) {
  const isResolved = why.expression !== undefined && why.argument !== true;
  return (
    <section className="why" aria-label="Why">
      <h3>{parameterHeadline(why)}</h3>
      <p>
        <CodeText text={why.reason} />
      </p>
      {isResolved && <Reads why={why} />}
      {isResolved && <p className="quiet">As things are {momentOfWhy(why, when)}.</p>}
    </section>
  );
}

/** The expression of a parameter, with what it reads. */
export function Reads({ why }: { readonly why: WhyParameter }) {
  return (
    <ul aria-label="What its expression reads">
      <li className="atom">
        <code>{why.expression}</code>
        <small className="reads">{namesText(why.reads) ?? "reads nothing"}</small>
      </li>
    </ul>
  );
}

/** What each atom waits for, of the present; nothing of the past, or if nothing waits. */
function useAwaited(why: WhyCondition): readonly (readonly string[])[] {
  const core = useCore();
  const services = useSession((s) => s.services);
  const isPast = useSession((s) => s.past !== undefined);
  const waits = !isPast && why.state_active && !isDone(why);
  const { waiting } = useHeld(waits ? core : undefined);
  const calls = core === undefined || !waits ? [] : openCallsOf(core, services);
  const now = useCellTime(calls.length > 0);
  return waits ? why.atoms.map((atom) => (atom.value === null ? awaitedTexts(atom, waiting, calls, now) : [])) : [];
}

/** The atoms of the condition, in the order of its text, with the ports that they read. */
export function Atoms({ why, waits = [] }: { readonly why: WhyCondition; readonly waits?: readonly (readonly string[])[] }) {
  const tree = useRunTree();
  const path = "port" in why ? (splitAddress(why.port)?.path ?? "") : why.state;
  return (
    <ul aria-label="Atoms of the condition">
      {why.atoms.map((atom, i) => {
        const advice = atomAdvice(why, atom);
        const reads = readsText(atom);
        return (
          <li key={i} className={`atom is-${truthText(atom.value)}${advice === undefined ? "" : " blocks"}`} data-blocks={atom.blocks}>
            <code>{atom.text}</code>
            <span className="truth">{truthText(atom.value)}</span>
            {reads !== undefined && <small className="reads">{reads}</small>}
            {tree !== undefined &&
              portsRead(tree, path, atom.text).map((address) => (
                <small key={address}>
                  <button type="button" className="link" onClick={() => view.dispatch({ type: "jump", selection: { kind: "port", address } })}>
                    {address}
                  </button>
                </small>
              ))}
            {waits[i]?.map((text) => (
              <small key={text} className="awaited">
                {text}
              </small>
            ))}
            {advice !== undefined && <small>{advice}</small>}
          </li>
        );
      })}
    </ul>
  );
}
