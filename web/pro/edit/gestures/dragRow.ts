// Dragging a row of the tree of states: onto a state it moves into it, to the edge of a row before or behind that.
import { moveBeside, moveInto } from "../../../shared/edit/commands/move";
import { nameOfElement, type Command } from "../../../shared/edit/commands/command";
import { elementOf } from "../../../shared/edit/tree";
import { selectedPaths } from "../../../shared/session/view";
import { view } from "../../client";
import { refusalNow } from "../../login/rights";
import { carryOut } from "../carryOut";
import type { ScreenPoint } from "../prompt";
import { situationNow, type Situation } from "../situation";
import type { Drag } from "./drag";
import { showDrag } from "./shown";

/** So much of a row, above and below, is beside it. */
const kEdge = 0.28;

type Where = "before" | "into" | "behind";

interface Target {
  readonly id: string;
  readonly where: Where;
  readonly box: DOMRect;
}

const idOf = ({ model }: Situation, path: string | undefined): string | undefined => model.get(path ?? "")?.node.id;

/** The row under a point, and the part of it. */
function targetAt(situation: Situation, { x, y }: ScreenPoint): Target | undefined {
  const row = document.elementFromPoint(x, y)?.closest<HTMLElement>('[role="treeitem"]');
  const id = idOf(situation, row?.dataset["path"]);
  if (row === null || row === undefined || id === undefined) return undefined;
  const box = row.getBoundingClientRect();
  const share = (y - box.top) / box.height;
  const isState = elementOf(situation.tree, id).kind === "state";
  // What is behind an unfolded state stands below all that is in it.
  const isOpen = row.getAttribute("aria-expanded") === "true";
  const isRoot = elementOf(situation.tree, id).list !== "children";
  const where = isRoot || (isState && share > kEdge && (isOpen || share < 1 - kEdge)) ? "into" : share < 0.5 ? "before" : "behind";
  return { id, where, box };
}

const commandFor = ({ tree }: Situation, ids: readonly string[], { id, where }: Target): Command => (where === "into" ? moveInto(tree, ids, id) : moveBeside(tree, ids, id, where));

/** The row, or the line between two rows. */
function shapeOf({ where, box }: Target): DOMRect {
  return where === "into" ? box : new DOMRect(box.x, (where === "before" ? box.top : box.bottom) - 1, box.width, 2);
}

/** The drag of the node at `path`, with all that is selected if it is. Nothing: it cannot be dragged. */
export function dragRow(path: string): Drag | undefined {
  if (refusalNow("edit") !== undefined) return undefined;
  const begun = situationNow();
  const own = begun && idOf(begun, path);
  if (begun === undefined || own === undefined || elementOf(begun.tree, own).list !== "children") return undefined;
  const ids = selectedPaths(view.get()).includes(path) ? begun.ids : [own];
  const [name, more] = [nameOfElement(begun.tree, own), ids.length - 1];
  const text = more > 0 ? `${name} and ${more} more` : name;
  const at = (point: ScreenPoint) => {
    const situation = situationNow();
    const isThere = situation !== undefined && ids.every((id) => situation.tree.elements.has(id));
    const target = isThere ? targetAt(situation, point) : undefined;
    return { target, command: situation && target && commandFor(situation, ids, target) };
  };
  return {
    move: (point) => {
      const { target, command } = at(point);
      const reason = command !== undefined && "reason" in command ? command.reason : undefined;
      showDrag({ target: target && reason === undefined ? shapeOf(target) : undefined, text: { at: point, text: reason ?? text, refused: reason !== undefined } });
    },
    drop: (point) => {
      const { command } = at(point);
      if (command !== undefined && "change" in command) carryOut(command);
    },
    end: () => showDrag(undefined),
  };
}
