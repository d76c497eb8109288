// The pose at which a step has failed is taught again while the run waits, or after its end; then the step is tried again, or the run begins anew.
import { useEffect, useRef, useState } from "react";
import type { CellMode, Core } from "../../generated/messages";
import { isOver } from "../../shared/run/controls";
import { useStop } from "../../stop/useStop";
import { api, attempt, useRefusal, useRefusalOfCommand } from "../client";
import { Teach } from "../teach/Teach";
import { texts } from "../texts";
import { begin } from "./begin";
import { goOnIn, holdForHand } from "./hold";

const t = texts.teachAgain;

interface ButtonsProps {
  readonly core: Core;
  readonly poses: readonly string[];
  /** Before anything is changed for it. */
  readonly onBegin: () => void;
  readonly onOpen: (pose: string) => void;
}

/** One for each pose of the step. */
export function TeachButtons({ core, poses, onBegin, onOpen }: ButtonsProps) {
  const refusal = useRefusal("take_controls");
  if (refusal !== undefined) return null;
  const open = (pose: string) =>
    attempt(async () => {
      onBegin();
      await holdForHand(core);
      onOpen(pose);
    });
  return (
    <>
      {poses.map((pose) => (
        <button key={pose} type="button" onClick={() => void open(pose)}>
          {poses.length === 1 ? t.open : t.title(pose)}
        </button>
      ))}
    </>
  );
}

interface Props {
  readonly name: string;
  readonly core: Core;
  readonly pose: string;
  /** The run goes on in this mode, or begins anew. */
  readonly mode: CellMode | undefined;
  /** The run goes on: what asks is to be answered that the step is tried again. */
  readonly onGoOn: () => void;
  readonly onClose: () => void;
}

export function TeachAgain({ name, core, pose, mode, onGoOn, onClose }: Props) {
  const [isSaved, setSaved] = useState(false);
  const [busy, setBusy] = useState(false);
  const title = useRef<HTMLHeadingElement>(null);
  useEffect(() => title.current?.focus(), []);
  const isBack = useStop((now) => now.mode === mode);
  const over = isOver(core);
  const ofMode = useRefusal("set_mode");
  const ofRun = useRefusalOfCommand(over ? "again" : "resume");
  const refusal = (isBack ? undefined : ofMode) ?? ofRun;
  const goOn = async () => {
    setBusy(true);
    await attempt(async () => {
      await goOnIn(mode, () => (over ? begin(name) : core.status === "running" && !core.paused ? Promise.resolve() : api.resume(core.id)));
      if (!over) onGoOn();
      onClose();
    });
    setBusy(false);
  };
  return (
    <section className="teach-again" aria-label={t.title(pose)}>
      <h2 ref={title} tabIndex={-1}>
        {t.title(pose)}
      </h2>
      <p>{over ? t.whenOver : t.whileHeld}</p>
      <Teach pose={pose} withOthers={false} onSaved={() => setSaved(true)} />
      <div className="buttons">
        <button type="button" className={isSaved ? "main" : ""} disabled={!isSaved || busy || refusal !== undefined} title={refusal} onClick={() => void goOn()}>
          {over ? texts.runView.startAgain : t.tryAgain}
        </button>
        <button type="button" disabled={busy} onClick={onClose}>
          {t.close}
        </button>
      </div>
      <p className="quiet" role="status">
        {!isSaved ? t.saveFirst(pose) : refusal !== undefined ? texts.runView.notNow(refusal) : t.keepAway}
      </p>
    </section>
  );
}
