// How the arm is controlled (shared/cell/control.ts), while this is mounted and the present is shown.
import { useEffect, useState } from "react";
import { collisionText, controlOf, kControl, markedCollision, whyItHolds } from "../../shared/cell/control";
import { useSession, watchFlow } from "../client";

export interface ShownControl {
  /** Why the arm does not go with a hand that pulls it. */
  readonly holds: string | undefined;
  /** The collision that is marked: at which link, and in words. */
  readonly link: string | undefined;
  readonly text: string | undefined;
}

const kNothing: ShownControl = { holds: undefined, link: undefined, text: undefined };

export function useControl(isPast: boolean): ShownControl {
  const robot = useSession(({ services }) => services.find(({ publishes, available }) => available && publishes.some(({ flow }) => flow === kControl))?.key);
  const [shown, setShown] = useState(kNothing);
  useEffect(() => {
    if (robot === undefined || isPast) return;
    const end = watchFlow(robot, kControl, (packet) => {
      const control = controlOf(packet);
      const collision = control && markedCollision(control);
      const next: ShownControl = { holds: control && whyItHolds(control), link: collision?.link, text: collision && collisionText(collision) };
      setShown((before) => (before.holds === next.holds && before.link === next.link && before.text === next.text ? before : next));
    });
    return () => {
      end();
      setShown(kNothing);
    };
  }, [robot, isPast]);
  return shown;
}
