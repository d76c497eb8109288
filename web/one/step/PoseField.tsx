// The name of a taught pose, and how the arm stands there.
import { lazy, Suspense, useEffect, useRef, useState, type KeyboardEvent } from "react";
import type { ExactJson } from "../../shared/edit/exact";
import { reasonAgainstPose } from "../../shared/skills/form";
import { useSession } from "../client";
import { loadPoses } from "../poses";
import { Teach } from "../teach/Teach";
import { texts } from "../texts";
import { closeAt, openAt, useIsOpenAt } from "./atPose";
import { usePoses } from "./known";

const t = texts.pose;

/** With the 3D view, which is large. */
const PosePreview = lazy(() => import("./PosePreview").then(({ PosePreview: shown }) => ({ default: shown })));

interface Props {
  /** The step, and the name of its parameter. */
  readonly step: string;
  readonly name: string;
  readonly id: string;
  readonly label: string;
  readonly disabled: boolean;
  readonly value: string | undefined;
  readonly set: (value: ExactJson) => void;
}

/** Of the list: another name is typed. */
const kOther = "";

export function PoseField({ step, name: parameter, id, label, disabled, value, set }: Props) {
  const { names, joints, problem } = usePoses();
  const known = value === undefined ? undefined : joints?.get(value);
  const [typed, setTyped] = useState<string>();
  const teaches = useIsOpenAt("taught", step, parameter);
  const shows = useIsOpenAt("shown", step, parameter);
  const teaching = useRef<HTMLDivElement>(null);
  useEffect(() => () => closeAt(step, parameter), [step, parameter]);
  useEffect(() => {
    teaching.current?.scrollIntoView({ block: "nearest" }); // gives a promise in some browsers
  }, [teaches]);
  const hasCell = useSession((s) => s.cell);
  const reason = typed === undefined || typed === "" ? undefined : reasonAgainstPose(typed);
  const choose = (name: string) => {
    setTyped(name === kOther ? "" : undefined);
    if (name !== kOther) set(name);
  };
  /** The list has the focus again. */
  const endTyping = () => {
    setTyped(undefined);
    document.getElementById(id)?.focus();
  };
  const take = () => {
    if (typed !== undefined && reasonAgainstPose(typed) === undefined) {
      set(typed);
      endTyping();
    }
  };
  const press = (event: KeyboardEvent) => {
    if (event.key === "Enter") take();
    if (event.key !== "Escape") return;
    event.stopPropagation();
    endTyping();
  };
  return (
    <div className="pose">
      <select id={id} disabled={disabled} onFocus={loadPoses} value={typed !== undefined ? kOther : (value ?? "-")} onChange={(event) => choose(event.target.value)}>
        {value === undefined && <option value="-">{texts.value.choose}</option>}
        {[...new Set([...(value === undefined ? [] : [value]), ...names])].map((name) => (
          <option key={name} value={name}>
            {name}
          </option>
        ))}
        <option value={kOther}>{t.another}</option>
      </select>
      {typed !== undefined && (
        <span className="add-text">
          <input aria-label={t.name(label)} autoFocus placeholder={t.hint} maxLength={32} value={typed} onChange={(event) => setTyped(event.target.value)} onKeyDown={press} />
          <button type="button" disabled={reasonAgainstPose(typed) !== undefined} onClick={take}>
            {t.use}
          </button>
        </span>
      )}
      {reason !== undefined && <p className="problem">{t.called(reason)}</p>}
      {value !== undefined && hasCell && (
        <button type="button" aria-expanded={shows} disabled={known === undefined || known.length === 0} onClick={() => openAt("shown", shows ? undefined : { step, parameter })}>
          {shows ? t.hide : t.show}
        </button>
      )}
      {!disabled && (
        <button type="button" aria-expanded={teaches} onClick={() => openAt("taught", teaches ? undefined : { step, parameter })}>
          {teaches ? texts.teach.close : texts.teach.open}
        </button>
      )}
      {teaches && !disabled && (
        <div ref={teaching}>
          <Teach pose={value} onSaved={(saved) => saved !== value && set(saved)} />
        </div>
      )}
      {problem !== undefined && <p className="problem">{t.unreadable(problem)}</p>}
      {joints !== undefined && value !== undefined && known === undefined && <p className="problem">{t.notTaught}</p>}
      {shows && known !== undefined && value !== undefined && (
        <Suspense fallback={<p className="doc">{t.loading}</p>}>
          <PosePreview key={value} name={value} joints={known} />
        </Suspense>
      )}
    </div>
  );
}
