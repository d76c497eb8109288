// The cell is moved by hand: who has the controls, the mode, and what can be moved while a button is held.
import { TakeButton } from "../../control/TakeButton";
import { kAxes, kJoints, kShares, movableOf, speedText, type JogPart } from "../../shared/control/jog";
import { holderText } from "../../shared/control/texts";
import { useStop } from "../../stop/useStop";
import { ownControls, useSession } from "../client";
import { useRefusal } from "../login/rights";
import { Gripper } from "./Gripper";
import { HoldButton } from "./HoldButton";
import { ModeSwitch } from "./ModeSwitch";
import { setMoving, useMoving } from "./moving";
import { SupervisedBox } from "./SupervisedBox";
import { useAngles } from "./useAngles";

export function ManualPanel() {
  const lost = useSession((s) => s.connection === "lost");
  const services = useSession((s) => s.services);
  const refused = useRefusal("move_by_hand");
  const refusal = lost ? "the server is not there" : refused;
  const take = useRefusal("take_controls");
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
        <ModeSwitch />
        <SupervisedBox />
      </div>
      <div className="manual-moves">
        <p className="manual-why" role="status">
          {refusal !== undefined ? `Nothing is moved by hand: ${refusal}.` : problem !== undefined ? `Not moved: ${problem}.` : ""}
        </p>
        <div className="manual-set">
          {robot === undefined ? <p className="quiet">No robot here can be moved by held buttons.</p> : <JogSettings />}
          {gripper !== undefined && <Gripper gripper={gripper} refusal={refusal} />}
        </div>
        {robot !== undefined && <Jogging robot={robot} refusal={refusal} />}
      </div>
    </section>
  );
}

const kJointParts: readonly JogPart[] = Array.from({ length: kJoints }, (_, joint) => ({ kind: "joint", joint }));
const kToolParts: readonly JogPart[] = [...kAxes.map((axis): JogPart => ({ kind: "linear", axis })), ...kAxes.map((axis): JogPart => ({ kind: "angular", axis }))];

function nameOf(part: JogPart): { readonly short: string; readonly long: string } {
  if (part.kind === "joint") return { short: `${part.joint + 1}`, long: `Joint ${part.joint + 1}` };
  const axis = part.axis.toUpperCase();
  return part.kind === "linear" ? { short: axis, long: `Tool along ${axis}` } : { short: `R${axis}`, long: `Tool around ${axis}` };
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
            const { short, long } = nameOf(part);
            return (
              <div key={long} className="manual-part">
                <b title={long}>{short}</b>
                {part.kind === "joint" && <span ref={(element) => place(part.joint, element)} />}
                <HoldButton part={part} sign={-1} name={long} refusal={refusal} />
                <HoldButton part={part} sign={1} name={long} refusal={refusal} />
              </div>
            );
          })}
        </div>
      ))}
    </>
  );
}
