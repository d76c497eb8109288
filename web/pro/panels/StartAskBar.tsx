// Asks, above the run bar, whether a run may move the robot that shall start. Enter starts, Esc does not.
import { useEffect, useMemo, useRef, useState } from "react";
import { movedBy, movesText } from "../../shared/run/moving";
import { isStopped } from "../../shared/stop/state";
import { useStop } from "../../stop/useStop";
import { useSession } from "../client";
import { CodeText } from "./CodeText";
import { Icon } from "./Icon";
import { SupervisedBox } from "../manual/SupervisedBox";
import { answerStart, stillHolds, useStartAsk, type StartAsk } from "./startAsk";

const kVerbs: Readonly<Partial<Record<StartAsk["command"], string>>> = { start: "Start", resume: "Resume", again: "Run again", micro: "Make a micro step", macro: "Make a macro step", until: "Make this step" };

export function StartAskBar() {
  const asked = useStartAsk();
  return asked === undefined ? null : <Question key={asked.core.id} asked={asked} />;
}

function Question({ asked }: { readonly asked: StartAsk }) {
  const [remember, setRemember] = useState(true);
  const before = useRef<Element>(null);
  const start = useRef<HTMLButtonElement>(null);
  const stopped = useStop(isStopped);
  const holds = useSession((s) => stillHolds(s, asked)) && !stopped;
  useEffect(() => {
    before.current = document.activeElement;
    start.current?.focus();
  }, []);
  const answer = (starts: boolean) => {
    answerStart(asked, starts, remember);
    if (before.current instanceof HTMLElement && before.current.isConnected) before.current.focus({ preventScroll: true });
  };
  useEffect(() => {
    if (!holds) answerStart(asked, false, false);
  }, [holds, asked]);
  const [model, services] = [useSession((s) => s.model), useSession((s) => s.services)];
  const moved = useMemo(() => movedBy(model, services), [model, services]);
  // It was asked before the task was here: now it is, and nothing moves.
  const isVoid = moved?.length === 0;
  useEffect(() => {
    if (holds && isVoid) answerStart(asked, true, false);
  }, [holds, isVoid, asked]);
  const verb = kVerbs[asked.command] ?? "Start";
  return (
    <div
      className="interruption start-ask"
      role="alertdialog"
      aria-label="Before it moves"
      aria-describedby="start-ask-text"
      onKeyDown={(event) => {
        if (event.key !== "Escape") return;
        event.preventDefault();
        event.stopPropagation();
        answer(false);
      }}
    >
      <Icon name="interrupted" />
      <div>
        <strong id="start-ask-text">
          <CodeText text={movesText(moved)} /> {verb}?
        </strong>
        <label>
          <input type="checkbox" checked={remember} onChange={(event) => setRemember(event.target.checked)} />
          Do not ask again for {asked.core.document} in this tab
        </label>
        <SupervisedBox />
      </div>
      <button type="button" ref={start} onClick={() => answer(true)}>
        {verb} <kbd>Enter</kbd>
      </button>
      <button type="button" onClick={() => answer(false)}>
        Not now <kbd>Esc</kbd>
      </button>
    </div>
  );
}
