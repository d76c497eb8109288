// Asks, above the run bar, whether a run may move the robot that a key has started. Enter starts, Esc does not.
import { useEffect, useMemo, useRef, useState } from "react";
import { commandOf } from "../../shared/session/shortcuts";
import { commandable } from "../../shared/session/session";
import { movedBy, movesText } from "../../shared/run/moving";
import { useSession } from "../client";
import { CodeText } from "./CodeText";
import { Icon } from "./Icon";
import { answerStart, useStartAsk, type StartAsk } from "./startAsk";

const kVerbs: Readonly<Partial<Record<StartAsk["command"], string>>> = { start: "Start", resume: "Resume", again: "Run again" };

export function StartAskBar() {
  const asked = useStartAsk();
  return asked === undefined ? null : <Question key={asked.id} asked={asked} />;
}

function Question({ asked }: { readonly asked: StartAsk }) {
  const [remember, setRemember] = useState(true);
  const before = useRef<Element>(null);
  const start = useRef<HTMLButtonElement>(null);
  // Another run is shown, or this one has been started meanwhile: the question is void.
  const holds = useSession((s) => s.watched === asked.id && commandOf("lead", commandable(s)) === asked.command);
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
  // The key came before the task was here: now it is, and nothing moves.
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
          Do not ask again for {asked.document} in this tab
        </label>
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
