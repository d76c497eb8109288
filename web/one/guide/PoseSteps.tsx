// The two places that are shown to the robot: of the part, and where it goes.
import { useEffect, useState } from "react";
import { keyOfPose, positionIn } from "../../shared/pendant/poses";
import { bystander } from "../client";
import { go, usePlace } from "../place";
import { Teach } from "../teach/Teach";
import { inMillimetres, useTool } from "../teach/useTool";
import { texts } from "../texts";
import { Ways } from "./Ways";

/** What is made of other poses is an application of its own. */
const kAnew = { edit: undefined } as const;

export function PartStep() {
  const part = usePlace((place) => place.part);
  return (
    <main className="guided-body">
      <p className="doc">{texts.part.check}</p>
      <Teach stem={texts.part.stem} onSaved={(name) => go({ part: name, ...kAnew })} />
      <Ways step="part" isReady={part !== undefined} />
    </main>
  );
}

export function PlaceStep() {
  const goal = usePlace((place) => place.goal);
  return (
    <main className="guided-body">
      <Height />
      <Teach stem={texts.place.stem} onSaved={(name) => go({ goal: name, ...kAnew })} />
      <Ways step="place" isReady={goal !== undefined} />
    </main>
  );
}

/** A difference that a part does not feel [m]. */
const kSame = 0.002;

/** How much higher the gripper is than where it was at the part, as the part is to stand on the same table. */
function Height() {
  const part = usePlace((place) => place.part);
  const tool = useTool();
  const [height, setHeight] = useState<number>();
  useEffect(() => {
    let isOver = false;
    if (part !== undefined)
      void bystander.callService("db", "get", { key: keyOfPose(part) }).then(
        (value) => isOver || setHeight(positionIn(value)?.[2]),
        () => undefined,
      );
    return () => {
      isOver = true;
    };
  }, [part]);
  if (tool === undefined || height === undefined) return null;
  const above = tool[2] - height;
  const { sameHeight, higher, lower } = texts.place;
  return <p className="guided-height">{Math.abs(above) <= kSame ? sameHeight : (above > 0 ? higher : lower)(inMillimetres(Math.abs(above)))}</p>;
}
