// A way around boxes: the shortest one with few bends, along lines beside the boxes (A*).
import type { Box, Point, Side } from "./drawing";
import type { Work } from "./work";

/** With more boxes near a line, no way around them is looked for. */
export const kMostObstacles = 40;
/** Steps of one search. */
const kMostSteps = 6000;
/** What a bend costs, as a length [px]. */
const kBend = 40;
/** What is kept free around a box [px]. */
const kClear = 4;

interface Visit {
  readonly column: number;
  readonly row: number;
  /** In which direction it was reached. */
  readonly across: boolean;
  readonly spent: number;
  readonly hoped: number;
  readonly before: Visit | undefined;
}

/** Takes what is hoped to be best: a binary heap. */
class Queue {
  private readonly heap: Visit[] = [];

  push(visit: Visit): void {
    const { heap } = this;
    let i = heap.push(visit) - 1;
    while (i > 0) {
      const above = (i - 1) >> 1;
      if (this.hopedAt(above) <= visit.hoped) break;
      this.swap(i, above);
      i = above;
    }
  }

  pop(): Visit | undefined {
    const { heap } = this;
    if (heap.length > 0) this.swap(0, heap.length - 1);
    const first = heap.pop();
    for (let i = 0, next = this.lesser(0); this.hopedAt(next) < this.hopedAt(i); next = this.lesser(i)) {
      this.swap(i, next);
      i = next;
    }
    return first;
  }

  private hopedAt(i: number): number {
    return this.heap[i]?.hoped ?? Infinity;
  }

  private lesser(i: number): number {
    return this.hopedAt(2 * i + 2) < this.hopedAt(2 * i + 1) ? 2 * i + 2 : 2 * i + 1;
  }

  private swap(i: number, j: number): void {
    const [a, b] = [this.heap[i], this.heap[j]];
    if (a === undefined || b === undefined) return;
    this.heap[i] = b;
    this.heap[j] = a;
  }
}

const ascending = (values: readonly number[]): readonly number[] => [...new Set(values)].sort((a, b) => a - b);

function wayTo(visit: Visit, xs: readonly number[], ys: readonly number[]): readonly Point[] {
  const points: Point[] = [];
  for (let at: Visit | undefined = visit; at !== undefined; at = at.before) points.push({ x: xs[at.column] ?? 0, y: ys[at.row] ?? 0 });
  return points.reverse();
}

/** The points from `start`, which is left in the direction of `leave`, to `end`; nothing if none is found with the work of one search. */
export function findWay(start: Point, end: Point, leave: Side, enter: Side, obstacles: readonly Box[], gap: number, work: Work): readonly Point[] | undefined {
  const xs = ascending([start.x, end.x, (start.x + end.x) / 2, ...obstacles.flatMap(({ x, width }) => [x - gap, x + width + gap])]);
  const ys = ascending([start.y, end.y, (start.y + end.y) / 2, ...obstacles.flatMap(({ y, height }) => [y - gap, y + height + gap])]);
  const isBlocked = (x: number, y: number) => obstacles.some((box) => x > box.x - kClear && x < box.x + box.width + kClear && y > box.y - kClear && y < box.y + box.height + kClear);
  const hopedFor = (column: number, row: number) => Math.abs((xs[column] ?? 0) - end.x) + Math.abs((ys[row] ?? 0) - end.y);
  const goal = { column: xs.indexOf(end.x), row: ys.indexOf(end.y) };
  const queue = new Queue();
  const done = new Set<number>();
  const first = { column: xs.indexOf(start.x), row: ys.indexOf(start.y), across: leave === "EAST" };
  queue.push({ ...first, spent: 0, hoped: hopedFor(first.column, first.row), before: undefined });
  for (let steps = 0; steps < kMostSteps; ++steps) {
    const at = queue.pop();
    if (at === undefined) return undefined;
    work.steps++;
    if (at.column === goal.column && at.row === goal.row) return wayTo(at, xs, ys);
    const key = 2 * (at.row * xs.length + at.column) + (at.across ? 1 : 0);
    if (done.has(key)) continue;
    done.add(key);
    for (const [right, down] of [[1, 0], [-1, 0], [0, 1], [0, -1]] as const) {
      const [column, row] = [at.column + right, at.row + down];
      const [x, y, x0, y0] = [xs[column], ys[row], xs[at.column] ?? 0, ys[at.row] ?? 0];
      if (x === undefined || y === undefined || isBlocked((x + x0) / 2, (y + y0) / 2)) continue;
      const across = down === 0;
      const arrives = column === goal.column && row === goal.row && across !== (enter === "EAST");
      const spent = at.spent + Math.abs(x - x0) + Math.abs(y - y0) + (across === at.across ? 0 : kBend) + (arrives ? kBend : 0);
      queue.push({ column, row, across, spent, hoped: spent + hopedFor(column, row), before: at });
    }
  }
  return undefined;
}
