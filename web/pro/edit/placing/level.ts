// The level that commands about places are for.
import { pathOf, type View } from "../../../shared/session/view";
import type { Laid } from "../../canvas/useDrawing";

/** The state whose children are placed: the one that is selected if its children are drawn, else that in which the selected one is. */
export function levelPath({ drawing, tree }: Laid, { selection }: View): string {
  const outermost = drawing.nodes[0]?.path ?? "";
  const selected = selection === undefined ? outermost : pathOf(selection);
  const drawn = drawing.nodes.find(({ path }) => path === selected);
  if (drawn === undefined || drawn.open || selected === outermost) return drawn === undefined ? outermost : selected;
  return tree.get(selected)?.parent ?? outermost;
}
