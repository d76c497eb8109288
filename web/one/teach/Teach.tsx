// The arm is moved where it is to be, while buttons are held, and that is saved: as the pose that is taught, or under a name that is free.
import { useState } from "react";
import { Before } from "../../control/Before";
import { GoToPose } from "../../control/GoToPose";
import { GripperButtons } from "../../control/GripperButtons";
import { GuidePart } from "../../control/GuidePart";
import { HandNotes } from "../../control/HandNotes";
import { JogPart } from "../../control/JogPart";
import { SavePose } from "../../control/SavePose";
import { SpeedSlider } from "../../control/SpeedSlider";
import { ToolNotice } from "../../control/ToolNotice";
import { movableOf } from "../../shared/control/jog";
import { hand } from "../hand";
import { texts } from "../texts";
import { SpeedHere } from "./SpeedHere";
import { inMillimetres, useTool } from "./useTool";

const t = texts.teach;
const kWays = ["tool", "joints", "hand"] as const;

interface Props {
  /** What names begin with. */
  readonly stem?: string;
  /** The pose that is taught, also anew. */
  readonly pose?: string | undefined;
  /** Another one can be saved beside `pose`. */
  readonly withOthers?: boolean;
  readonly onSaved: (name: string) => void;
}

export function Teach({ stem, pose, withOthers = true, onSaved }: Props) {
  const [last, setLast] = useState<string>();
  const [way, setWay] = useState<(typeof kWays)[number]>("tool");
  const services = hand.useServices();
  const { robot, gripper } = movableOf(services);
  const refusal = hand.useRefusal("move_by_hand");
  const refused = hand.useMoving((now) => now.refused);
  const shown = pose ?? last;
  const taught = hand.usePoses((now) => now.poses.find(({ name }) => name === shown));
  const saved = (name: string) => {
    setLast(name);
    onSaved(name);
  };
  if (robot === undefined) return <p className="problem">{t.noRobot}</p>;
  return (
    <section className="teach" aria-label={t.name}>
      <h2 className="unseen">{t.name}</h2>
      {refusal !== undefined && <Before hand={hand} />}
      <HandNotes said={refusal === undefined && refused !== undefined ? t.notMoved(refused) : ""}>
        <ToolNotice services={services} />
      </HandNotes>
      <div className="ways" role="group" aria-label={t.how}>
        {kWays.map((each) => (
          <button key={each} type="button" aria-pressed={each === way} onClick={() => setWay(each)}>
            {t.ways[each]}
          </button>
        ))}
      </div>
      {way === "hand" ? <GuidePart hand={hand} refusal={refusal} /> : <JogPart hand={hand} kind={way} refusal={refusal} />}
      {way !== "hand" && <SpeedSlider hand={hand} />}
      {gripper !== undefined && <GripperButtons gripper={gripper} refusal={refusal} />}
      <Where />
      {taught !== undefined && <GoToPose hand={hand} pose={taught} refusal={refusal} />}
      {pose !== undefined && <SavePose key={pose} hand={hand} isNamed={false} fixed={pose} onSaved={saved} />}
      {(pose === undefined || withOthers) && <SavePose hand={hand} isNamed={false} {...(stem !== undefined && { stem })} onSaved={saved} />}
      <SpeedHere />
    </section>
  );
}

function Where() {
  const tool = useTool();
  if (tool === undefined) return null;
  const [x, y, z] = tool;
  return <p className="doc">{t.at(inMillimetres(x), inMillimetres(y), inMillimetres(z))}</p>;
}
