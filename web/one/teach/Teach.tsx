// The arm is moved where it is to be, while buttons are held, and that is saved under a name that is free.
import { useEffect, useState } from "react";
import { Before } from "../../control/Before";
import { GripperButtons } from "../../control/GripperButtons";
import { GuidePart } from "../../control/GuidePart";
import { JogPart } from "../../control/JogPart";
import { SpeedSlider } from "../../control/SpeedSlider";
import { movableOf } from "../../shared/control/jog";
import { freeName } from "../../shared/pendant/poses";
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
      <Save stem={stem} onSaved={onSaved} />
    </section>
  );
}

function Where() {
  const tool = useTool();
  if (tool === undefined) return null;
  const [x, y, z] = tool;
  return <p className="doc">{t.at(inMillimetres(x), inMillimetres(y), inMillimetres(z))}</p>;
}

function Save({ stem, onSaved }: { readonly stem: string | undefined; readonly onSaved: (name: string) => void }) {
  const refusal = hand.useRefusal("call_service");
  const isLoaded = hand.usePoses((now) => now.isLoaded);
  const names = hand.usePoses((now) => now.names);
  const [busy, setBusy] = useState(false);
  const [said, setSaid] = useState<{ readonly text: string; readonly isBad: boolean }>();
  useEffect(() => hand.poses.load(), []);
  const name = freeName(names, stem);
  const save = async () => {
    setBusy(true);
    const problem = await hand.poses.save(name);
    setBusy(false);
    setSaid(problem === undefined ? { text: t.saved(name), isBad: false } : { text: t.notSaved(problem), isBad: true });
    if (problem === undefined) onSaved(name);
  };
  return (
    <>
      <button type="button" className="main" disabled={busy || !isLoaded || refusal !== undefined} title={refusal} onClick={() => void save()}>
        {busy ? t.saving : t.save(name)}
      </button>
      <p role="status" className={said?.isBad === true ? "problem" : "doc"}>
        {said?.text ?? ""}
      </p>
    </>
  );
}
