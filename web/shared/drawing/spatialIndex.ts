// A spatial index of boxes: which of them meet a part of the drawing, found without looking at the others.
import type { Box, Point } from "./drawing";
import { noWork, type Work } from "./work";

export interface SpatialIndex<T extends Box> {
  /** The items that meet `area`, in the order in which they were given. */
  readonly within: (area: Box) => readonly T[];
  /** The items that contain the point, in the order in which they were given. */
  readonly at: (point: Point) => readonly T[];
  /** How many items that meet `area` satisfy `test`; counting ends with `most`. */
  readonly count: (area: Box, test: (item: T) => boolean, most?: number) => number;
  /** Adds an item, behind the others. */
  readonly add: (item: T) => void;
}

/** Side of a cell of the grid: about as large as a state. */
const kCell = 256;
/** A box over more cells is tested each time instead. */
const kMostCells = 64;
/** Cells are numbered row by row; nothing lies in a row or column farther from the origin. */
const kFarthest = 2 ** 25;

const meets = (a: Box, b: Box): boolean => a.x <= b.x + b.width && b.x <= a.x + a.width && a.y <= b.y + b.height && b.y <= a.y + a.height;

interface Cells {
  readonly left: number;
  readonly right: number;
  readonly top: number;
  readonly bottom: number;
}

const cellOf = (coordinate: number): number => Math.max(-kFarthest, Math.min(kFarthest - 1, Math.floor(coordinate / kCell)));

const cellsOf = ({ x, y, width, height }: Box): Cells => ({ left: cellOf(x), right: cellOf(x + width), top: cellOf(y), bottom: cellOf(y + height) });

const countOf = ({ left, right, top, bottom }: Cells): number => (right - left + 1) * (bottom - top + 1);

const numberOf = (row: number, column: number): number => row * 2 * kFarthest + column;

/** `work` counts the cells and items that are looked at. */
export function spatialIndex<T extends Box>(given: readonly T[], work: Work = noWork()): SpatialIndex<T> {
  const items: T[] = [];
  const grid = new Map<number, number[]>();
  const large: number[] = [];
  /** In which search an item was met last: one that lies in several cells is met once. */
  const met: number[] = [];
  let search = 0;

  const add = (item: T): void => {
    const i = items.push(item) - 1;
    met.push(0);
    const cells = cellsOf(item);
    if (countOf(cells) > kMostCells) {
      large.push(i);
      return;
    }
    for (let row = cells.top; row <= cells.bottom; row++)
      for (let column = cells.left; column <= cells.right; column++) {
        const key = numberOf(row, column);
        const cell = grid.get(key);
        if (cell === undefined) grid.set(key, [i]);
        else cell.push(i);
      }
  };
  for (const item of given) add(item);

  /** Calls `take` with each item that meets `area`, in any order, until it says that it has enough. */
  const visit = (area: Box, take: (item: T, i: number) => boolean): void => {
    search++;
    const test = (i: number): boolean => {
      if (met[i] === search) return false;
      met[i] = search;
      work.looks++;
      const item = items[i];
      return item !== undefined && meets(item, area) && take(item, i);
    };
    const cells = cellsOf(area);
    // An area with more cells than there are items: all of them.
    if (countOf(cells) > grid.size) {
      for (let i = 0; i < items.length; i++) if (test(i)) return;
      return;
    }
    for (const i of large) if (test(i)) return;
    for (let row = cells.top; row <= cells.bottom; row++)
      for (let column = cells.left; column <= cells.right; column++) {
        work.looks++;
        const cell = grid.get(numberOf(row, column));
        if (cell !== undefined) for (const i of cell) if (test(i)) return;
      }
  };

  const within = (area: Box): readonly T[] => {
    const found: number[] = [];
    visit(area, (_, i) => (found.push(i), false));
    return found.sort((a, b) => a - b).flatMap((i) => items[i] ?? []);
  };
  const count = (area: Box, test: (item: T) => boolean, most = Infinity): number => {
    let sum = 0;
    if (most > 0) visit(area, (item) => test(item) && ++sum >= most);
    return sum;
  };
  return { within, at: ({ x, y }) => within({ x, y, width: 0, height: 0 }), count, add };
}
