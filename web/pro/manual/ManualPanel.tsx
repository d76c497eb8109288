// The cell is moved by hand: who has the controls, the mode, and what can be moved while a button is held.
import { GripperButtons } from "../../control/GripperButtons";
import { HandNotes } from "../../control/HandNotes";
import { JogButton } from "../../control/JogButton";
import { ModeSwitch } from "../../control/ModeSwitch";
import { SpeedOverride } from "../../control/SpeedOverride";
import { TakeButton } from "../../control/TakeButton";
import { ToolNotice } from "../../control/ToolNotice";
import { kJointParts, kShares, kToolParts, movableOf, partName, speedText } from "../../shared/control/jog";
import { holderText } from "../../shared/control/texts";
import { useStop } from "../../stop/useStop";
import { fetchWithControls, ownControls, problem as showProblem, robotSpeed, useSession } from "../client";
import { useRefusal } from "../login/rights";
import { moving, setMoving, useMoving } from "./moving";
import { SupervisedBox } from "./SupervisedBox";
import { useAngles } from "./useAngles";

export function ManualPanel() {
  const lost = useSession((s) => s.connection === "lost");
  const services = useSession((s) => s.services);
  const refused = useRefusal("move_by_hand");
  const refusal = lost ? "the server is not there" : refused;
  const take = useRefusal("take_controls");
  const mode = useRefusal("set_mode");
  const speed = useRefusal("set_speed");
  const who = useStop((stop) => holderText(stop.holder, stop.held));
  const { robot, gripper } = movableOf(services);
  const problem = useMoving((now) => now.refused);
  return (
    <section className="manual" aria-label="Manual control">
      <div className="manual-who">
        <h3>{who}</h3>
        <div>
          <TakeButton address={ownControls} refusal={lost ? "the server is not there" : take} />
        </div>
        <ModeSwitch refusal={mode} fetcher={fetchWithControls} onProblem={showProblem} />
        <SupervisedBox />
        <SpeedOverride speed={robotSpeed} refusal={lost ? "the server is not there" : speed} />
      </div>
      <div className="manual-moves">
        <HandNotes said={refusal !== undefined ? `Nothing is moved by hand: ${refusal}.` : problem !== undefined ? `Not moved: ${problem}.` : ""}>
          <ToolNotice services={services} />
        </HandNotes>
        <div className="manual-set">
          {robot === undefined ? <p className="quiet">No robot here can be moved by held buttons.</p> : <JogSettings />}
          {gripper !== undefined && <GripperButtons gripper={gripper} refusal={refusal} />}
        </div>
        {robot !== undefined && <Jogging robot={robot} refusal={refusal} />}
      </div>
    </section>
  );
}

function JogSettings() {
  const share = useMoving((now) => now.share);
  const frame = useMoving((now) => now.frame);
  return (
    <>
      <label>
        Speed
        <input type="range" min={kShares.least} max={kShares.most} step={kShares.step} value={share} aria-valuetext={speedText(share)} onChange={(event) => setMoving({ share: Number(event.target.value) })} />
        <span>{speedText(share)}</span>
      </label>
      <label>
        Tool along
        <select value={frame} onChange={(event) => setMoving({ frame: event.target.value === "tool" ? "tool" : "o" })}>
          <option value="o">o, the cell</option>
          <option value="tool">its own axes</option>
        </select>
      </label>
    </>
  );
}

function Jogging({ robot, refusal }: { readonly robot: string; readonly refusal: string | undefined }) {
  const place = useAngles();
  return (
    <>
      {[{ title: "Joints", parts: kJointParts }, { title: "Tool", parts: kToolParts }].map(({ title, parts }) => (
        <div key={title} className="manual-parts" role="group" aria-label={`${title} of ${robot}`}>
          <h3>{title}</h3>
          {parts.map((part) => {
            const { short, long } = partName(part);
            return (
              <div key={long} className="manual-part">
                <b title={long}>{short}</b>
                {part.kind === "joint" && <span ref={(element) => place(part.joint, element)} />}
                <JogButton part={part} sign={-1} refusal={refusal} moving={moving} />
                <JogButton part={part} sign={1} refusal={refusal} moving={moving} />
              </div>
            );
          })}
        </div>
      ))}
    </>
  );
}
