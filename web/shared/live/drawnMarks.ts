// The signs of a difference in a drawing: for each node and port that stands for rows of it, where it is and what has become of it.
import type { Box } from "../drawing/drawing";
import type { Compared } from "../edit/difference/compare";
import { selectionsOf, type Selection } from "../model/identity";
import type { DrawnModel } from "../versions/ghosts";
import { markOf, rowsByPlace, type Mark } from "./marks";

export interface DrawnMark extends Mark {
  readonly id: string;
  /** Of the node or port. */
  readonly box: Box;
}

/** What is drawn of nodes and ports, by path and address. */
const boxesOf = ({ drawing }: DrawnModel): ReadonlyMap<string, Box> =>
  new Map(drawing.nodes.flatMap((node): readonly (readonly [string, Box])[] => [[node.path, node], ...node.ports.map((port): readonly [string, Box] => [port.address, port])]));

const addressOf = (selection: Selection): string => (selection.kind === "node" ? selection.path : selection.address);

/** Rows of what is not drawn are told by the state around it. */
export function drawnMarks({ before, after, rows }: Pick<Compared, "before" | "after" | "rows">, drawn: DrawnModel): readonly DrawnMark[] {
  const [boxes, selections] = [boxesOf(drawn), selectionsOf(drawn.tree)];
  const boxAt = (id: string): Box | undefined => {
    const selection = selections.get(id);
    return selection && boxes.get(addressOf(selection));
  };
  const places = rowsByPlace(before, after, rows, (id) => boxAt(id) !== undefined);
  return [...places].flatMap(([id, at]) => {
    const box = boxAt(id);
    return box === undefined ? [] : [{ id, box, ...markOf(id, at) }];
  });
}
