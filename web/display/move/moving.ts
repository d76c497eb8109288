// The one motion by hand of this page.
import { createMoving, type MovingState } from "../../control/moving";
import { useSelected } from "../../page/store";
import { refusalNow, session } from "../client";
import { buzz } from "../signals";

export const moving = createMoving({
  refusal: () => refusalNow("move_by_hand"),
  services: () => session.get().services,
  onRefused: () => buzz("refused"),
  onArrived: () => buzz("press"),
});
export const useMoving = <T>(select: (now: MovingState) => T): T => useSelected(moving.store, select);
