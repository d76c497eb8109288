// The one motion by hand of this page.
import { createMoving, type MovingState } from "../../control/moving";
import { useSelected } from "../../page/store";
import { session } from "../client";
import { refusalNow } from "../login/rights";

export const moving = createMoving({ refusal: () => refusalNow("move_by_hand"), services: () => session.get().services });
export const useMoving = <T>(select: (now: MovingState) => T): T => useSelected(moving.store, select);
export const setMoving = moving.set;
