// Who has the controls of the cell, its mode, and whether the robot is slowed down; that this page has lost them, and why; and who asks for them.
import type { ReactNode } from "react";
import { createPortal } from "react-dom";
import type { RobotSpeed } from "../page/pageStream";
import { useSelected } from "../page/store";
import { speedSign } from "../shared/control/speed";
import { isOwn, holderText, linkWarning, modeText } from "../shared/control/texts";
import { useStop } from "../stop/useStop";
import { useNotesPlace } from "./HandNotes";
import { controls, useControls } from "./page";
import { RequestBar } from "./RequestBar";
import { SpeedSign } from "./SpeedSign";
import { TakeButton, type TakeProps } from "./TakeButton";
import { texts } from "./texts";

interface Props extends TakeProps {
  /** Also while nobody has them and runs go by themselves. */
  readonly always: boolean;
  /** Why this person does not answer who asks for them. */
  readonly refusalToAnswer: string | undefined;
  /** Of the account. */
  readonly fetcher: typeof fetch;
  readonly speed: RobotSpeed;
  /** Sets the speed, while it is not the whole; nothing: the page does that under `Run`. Where the robot is moved by hand (HandNotes.tsx), the page has it there. */
  readonly children?: ReactNode;
}

export function ControlBar({ always, address, refusal, refusalToAnswer, fetcher, speed, children }: Props) {
  const mode = useStop((stop) => stop.mode);
  const holder = useStop((stop) => stop.holder);
  const held = useStop((stop) => stop.held);
  const request = useStop((stop) => stop.request);
  const link = useControls((state) => state);
  const notes = useNotesPlace();
  const warning = linkWarning(link, holder);
  const sign = speedSign(useSelected(speed.store, ({ share }) => share));
  const others = request !== null && !(link.kind === "asked" && link.request === request.id) ? request : undefined;
  if (mode === undefined && warning === undefined && sign === undefined) return null;
  if (!always && holder === null && held === undefined && mode !== "programming" && link.kind === "none" && others === undefined && sign === undefined) return null;
  const isMine = isOwn(holder, held);
  const comes = (
    <>
      {sign !== undefined && (
        <SpeedSign sign={sign} isSetHere={children !== undefined}>
          {notes === undefined ? children : undefined}
        </SpeedSign>
      )}
      {others !== undefined && <RequestBar key={others.id} request={others} refusal={refusalToAnswer} fetcher={fetcher} />}
    </>
  );
  return (
    <section className={`control-bar${isMine ? " is-mine" : ""}${mode === "programming" ? " is-programming" : ""}`} aria-label={texts.bar.name}>
      {warning !== undefined && (
        <div className="control-lost">
          <p role="alert" aria-live="assertive">
            <strong>{warning.title}</strong> <span>{[warning.why, ...(warning.means === undefined ? [] : [warning.means.replace(/\.$/, "")])].join(". ")}.</span>
          </p>
          <button type="button" onClick={() => controls.dismiss()}>
            {texts.bar.read}
          </button>
        </div>
      )}
      {mode !== undefined && (
        <div className="control-line">
          <p role="status">
            <b>{modeText(mode)}</b> <strong>{holderText(holder, held)}</strong>
          </p>
          <div>
            <TakeButton address={address} refusal={refusal} />
            {refusal !== undefined && <small className="unseen">{texts.bar.noTaking(refusal)}</small>}
          </div>
        </div>
      )}
      {notes === undefined ? comes : createPortal(comes, notes)}
    </section>
  );
}
