// Selecting what a rubber band encloses.
import { selectedPaths } from "../../../shared/session/view";
import { view } from "../../client";
import type { ScreenPoint } from "../prompt";
import type { Drag } from "./drag";
import { nodesWithin } from "./onScreen";
import { showDrag } from "./shown";

const boxBetween = (a: ScreenPoint, b: ScreenPoint): DOMRect => new DOMRect(Math.min(a.x, b.x), Math.min(a.y, b.y), Math.abs(a.x - b.x), Math.abs(a.y - b.y));

/** What it encloses is selected besides what is selected already. */
export function bandFrom(start: ScreenPoint): Drag {
  return {
    move: (at) => showDrag({ band: boxBetween(start, at) }),
    drop: (at) => view.dispatch({ type: "select_all", paths: [...new Set([...selectedPaths(view.get()), ...nodesWithin(boxBetween(start, at))])] }),
    end: () => showDrag(undefined),
  };
}
