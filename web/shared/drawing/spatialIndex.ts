// A spatial index of boxes: which of them meet a part of the drawing, found without looking at the others.
import type { Box, Point } from "./drawing";

export interface SpatialIndex<T extends Box> {
  /** The items that meet `area`, in the order in which they were given. */
  readonly within: (area: Box) => readonly T[];
  /** The items that contain the point, in the order in which they were given. */
  readonly at: (point: Point) => readonly T[];
  /** Adds an item, behind the others. */
  readonly add: (item: T) => void;
}

/** Side of a cell of the grid: about as large as a state. */
const kCell = 256;
/** A box over more cells is tested each time instead. */
const kMostCells = 64;

const meets = (a: Box, b: Box): boolean => a.x <= b.x + b.width && b.x <= a.x + a.width && a.y <= b.y + b.height && b.y <= a.y + a.height;

interface Cells {
  readonly left: number;
  readonly right: number;
  readonly top: number;
  readonly bottom: number;
}

const cellsOf = ({ x, y, width, height }: Box): Cells => ({
  left: Math.floor(x / kCell),
  right: Math.floor((x + width) / kCell),
  top: Math.floor(y / kCell),
  bottom: Math.floor((y + height) / kCell),
});

const countOf = ({ left, right, top, bottom }: Cells): number => (right - left + 1) * (bottom - top + 1);

function* keysOf({ left, right, top, bottom }: Cells): Generator<string> {
  for (let row = top; row <= bottom; row++) for (let column = left; column <= right; column++) yield `${column} ${row}`;
}

export function spatialIndex<T extends Box>(given: readonly T[]): SpatialIndex<T> {
  const items: T[] = [];
  const grid = new Map<string, number[]>();
  const large: number[] = [];
  const add = (item: T): void => {
    const i = items.push(item) - 1;
    const cells = cellsOf(item);
    if (countOf(cells) > kMostCells) {
      large.push(i);
      return;
    }
    for (const key of keysOf(cells)) {
      const cell = grid.get(key);
      if (cell === undefined) grid.set(key, [i]);
      else cell.push(i);
    }
  };
  given.forEach(add);
  const within = (area: Box): readonly T[] => {
    const cells = cellsOf(area);
    // An area with more cells than there are items: all of them.
    if (countOf(cells) > grid.size) return items.filter((item) => meets(item, area));
    const found = new Set(large);
    for (const key of keysOf(cells)) grid.get(key)?.forEach((i) => found.add(i));
    return [...found]
      .sort((a, b) => a - b)
      .flatMap((i) => items[i] ?? [])
      .filter((item) => meets(item, area));
  };
  return { within, at: ({ x, y }) => within({ x, y, width: 0, height: 0 }), add };
}
