// The camera is calibrated by a run of the skill, unless that is done already or there is no camera.
import { useEffect, useState } from "react";
import { isOver } from "../../shared/run/controls";
import { bystander, useCore, useSession } from "../client";
import { useOffered } from "../library/offered";
import { usePlace } from "../place";
import { RunView } from "../run/RunView";
import { loadSkills } from "../skills";
import { texts } from "../texts";
import { MakeButton } from "./MakeButton";
import { useMaking } from "./useMaking";
import { Ways } from "./Ways";

const t = texts.camera;
const kSkill = "CalibrateCamera";
const kDocument = "calibrate-camera";
const kWanted = [{ skill: kSkill, values: {} }] as const;
/** Where the pose of the camera is kept (deploy/demo). */
const kKey = "o_t_c";

/** Whether it is known where the camera stands; nothing: not asked yet. */
function useKnown(): boolean | undefined {
  const core = useCore();
  const over = core === undefined || isOver(core);
  const [known, setKnown] = useState<boolean>();
  useEffect(() => {
    let isLate = false;
    if (over)
      void bystander.callService("db", "get", { key: kKey }).then(
        () => isLate || setKnown(true),
        () => isLate || setKnown(false),
      );
    return () => {
      isLate = true;
    };
  }, [over]);
  return known;
}

export function CameraStep() {
  const edit = usePlace((place) => place.edit);
  const core = useCore();
  // The run of the calibration goes on: the arm cannot be moved by hand meanwhile.
  const isMoving = core !== undefined && core.status !== "ready" && !isOver(core);
  const documents = useSession((now) => now.documents);
  const known = useKnown();
  useEffect(() => void loadSkills(), [documents]);
  const skill = useOffered().find(({ name }) => name === kSkill);
  const making = useMaking(kDocument, t.task, kWanted);
  const { made, busy, problem } = making;
  if (edit !== undefined && (made === "yes" || made === "opening") && !busy && problem === undefined)
    return (
      <>
        <RunView name={edit} />
        <section className="guided-body is-below" aria-label={texts.guide.ways}>
          {!isMoving && known !== true && <p className="doc">{t.skip}</p>}
          <Ways step="camera" isReady={!isMoving} />
        </section>
      </>
    );
  const missing = skill === undefined ? texts.cell.noSkills(t.task) : skill.missing;
  return (
    <main className="guided-body">
      {known === undefined ? <p role="status">{t.asking}</p> : known ? <p>{t.known}</p> : missing !== undefined ? <p>{t.notNeeded(missing)}</p> : null}
      {known === false && missing === undefined && <MakeButton {...making} label={t.begin} making={t.making} />}
      {known === false && <p className="doc">{t.skip}</p>}
      <Ways step="camera" isReady={!busy} />
    </main>
  );
}
