// What is there: the arm, the gripper, the camera.
import { movableOf } from "../../shared/control/jog";
import { recognitionOf } from "../../shared/skills/labels";
import { useSession } from "../client";
import { hand } from "../hand";
import { texts } from "../texts";
import { Ways } from "./Ways";

const t = texts.cell;

export function CellStep() {
  const services = hand.useServices();
  const isHere = useSession((now) => now.connection === "open" && now.services.length > 0);
  const { robot, gripper } = movableOf(services);
  const camera = recognitionOf(services);
  const rows = [
    [robot !== undefined, t.robot, t.noRobot],
    [gripper !== undefined, t.gripper, t.noGripper],
    [camera !== undefined, t.camera, t.noCamera],
  ] as const;
  const isReady = robot !== undefined && gripper !== undefined;
  return (
    <main className="guided-body">
      {isHere ? (
        <ul className="guided-list" aria-label={t.list}>
          {rows.map(([isThere, text, missing]) => (
            <li key={text} className={isThere ? "is-there" : ""}>
              <b aria-hidden="true">{isThere ? "✓" : "–"}</b> {isThere ? text : missing}
            </li>
          ))}
        </ul>
      ) : (
        <p role="status">{t.asking}</p>
      )}
      {isHere && !isReady && <p className="problem">{t.cannot}</p>}
      <Ways step="cell" isReady={isReady} />
    </main>
  );
}
