// The robot is moved by hand: what is missing for it, or how it is moved.
import { Before } from "../../control/Before";
import { GripperButtons } from "../../control/GripperButtons";
import { GuidePart } from "../../control/GuidePart";
import { HandNotes } from "../../control/HandNotes";
import { JogPart } from "../../control/JogPart";
import { SavePose } from "../../control/SavePose";
import { SpeedSlider } from "../../control/SpeedSlider";
import { ToolNotice } from "../../control/ToolNotice";
import { movableOf } from "../../shared/control/jog";
import { kMoveParts } from "../../shared/pendant/view";
import { useRefusal, useSession } from "../client";
import { goTo, usePlace } from "../place";
import { Asking, Problems } from "../Status";
import { texts } from "../texts";
import { hand } from "./hand";
import { PosesPart } from "./PosesPart";

export function MoveView() {
  const services = useSession((now) => now.services);
  const part = usePlace((place) => place.part);
  const refusal = useRefusal("move_by_hand");
  const refused = hand.useMoving((now) => now.refused);
  const { robot, gripper } = movableOf(services);
  const notes = (
    <HandNotes said={refusal === undefined && refused !== undefined ? texts.move.refused(refused) : ""}>
      <ToolNotice services={services} />
      <Problems />
      <Asking />
    </HandNotes>
  );
  if (robot === undefined && gripper === undefined)
    return (
      <div className="move">
        {notes}
        <p className="empty">{texts.move.nothing}</p>
      </div>
    );
  return (
    <div className="move">
      <h2 className="unseen">{texts.move.title}</h2>
      {refusal !== undefined && <Before hand={hand} />}
      {notes}
      <div className="parts" role="group" aria-label={texts.move.how}>
        {kMoveParts.map((each) => (
          <button key={each} type="button" aria-pressed={each === part} onClick={() => goTo({ part: each })}>
            {texts.move.parts[each]}
          </button>
        ))}
      </div>
      {robot !== undefined && (
        <>
          {part === "hand" ? (
            <GuidePart hand={hand} refusal={refusal}>
              <SavePose hand={hand} isNamed />
            </GuidePart>
          ) : part === "poses" ? (
            <PosesPart refusal={refusal} />
          ) : (
            <JogPart hand={hand} kind={part} refusal={refusal} />
          )}
          {part !== "hand" && <SpeedSlider hand={hand} />}
        </>
      )}
      {gripper !== undefined && <GripperButtons gripper={gripper} refusal={refusal} />}
    </div>
  );
}
