// Whether a part of a drawing looks as it did before: it is copied then, not painted again.
import type { Box } from "./drawing";
import { showsInside } from "./levels";
import type { Scene, SceneItem } from "./scene";

const drawnOf = (item: SceneItem): unknown => (item.kind === "node" ? item.node : item.line);

/** The same object, or one of the same content: the frame around what has changed is made anew. */
const isSame = (one: SceneItem, other: SceneItem | undefined): boolean =>
  one === other || (other !== undefined && (drawnOf(one) === drawnOf(other) || JSON.stringify(drawnOf(one)) === JSON.stringify(drawnOf(other))));

/** Whether `area` looks the same in both, at this zoom. */
export function looksSame(before: Scene, after: Scene, area: Box, zoom: number): boolean {
  if (before === after) return true;
  const seen = ({ items }: Scene) => items.within(area).filter(({ inside }) => inside === undefined || showsInside(inside, zoom));
  const [was, is] = [seen(before), seen(after)];
  return was.length === is.length && was.every((item, i) => isSame(item, is[i]));
}
