// The arm is moved where it is to be, while buttons are held, and that is saved under a name that is free.
import { useState } from "react";
import { Before } from "../../control/Before";
import { GripperButtons } from "../../control/GripperButtons";
import { GuidePart } from "../../control/GuidePart";
import { JogPart } from "../../control/JogPart";
import { SavePose } from "../../control/SavePose";
import { SpeedSlider } from "../../control/SpeedSlider";
import { movableOf } from "../../shared/control/jog";
import { hand } from "../hand";
import { texts } from "../texts";
import { inMillimetres, useTool } from "./useTool";

const t = texts.teach;
const kWays = ["tool", "joints", "hand"] as const;

interface Props {
  /** What names begin with. */
  readonly stem?: string;
  readonly onSaved: (name: string) => void;
}

export function Teach({ stem, onSaved }: Props) {
  const [way, setWay] = useState<(typeof kWays)[number]>("tool");
  const { robot, gripper } = movableOf(hand.useServices());
  const refusal = hand.useRefusal("move_by_hand");
  const refused = hand.useMoving((now) => now.refused);
  if (robot === undefined) return <p className="problem">{t.noRobot}</p>;
  return (
    <section className="teach" aria-label={t.name}>
      <h2 className="unseen">{t.name}</h2>
      {refusal !== undefined && <Before hand={hand} />}
      <div className="ways" role="group" aria-label={t.how}>
        {kWays.map((each) => (
          <button key={each} type="button" aria-pressed={each === way} onClick={() => setWay(each)}>
            {t.ways[each]}
          </button>
        ))}
      </div>
      <p className="problem" role="status">
        {refusal === undefined && refused !== undefined ? t.notMoved(refused) : ""}
      </p>
      {way === "hand" ? <GuidePart hand={hand} refusal={refusal} /> : <JogPart hand={hand} kind={way} refusal={refusal} />}
      {way !== "hand" && <SpeedSlider hand={hand} />}
      {gripper !== undefined && <GripperButtons gripper={gripper} refusal={refusal} />}
      <Where />
      <SavePose hand={hand} isNamed={false} {...(stem !== undefined && { stem })} onSaved={onSaved} />
    </section>
  );
}

function Where() {
  const tool = useTool();
  if (tool === undefined) return null;
  const [x, y, z] = tool;
  return <p className="doc">{t.at(inMillimetres(x), inMillimetres(y), inMillimetres(z))}</p>;
}
