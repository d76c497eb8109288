// SVG paths of laid out lines: straight pieces with rounded corners.
import type { Point } from "./drawing";

/** `M … L … Q …` through the points, each corner rounded with at most `radius`. */
export function roundedPath(points: readonly Point[], radius: number): string {
  const [start, ...rest] = points;
  if (start === undefined) return "";
  const parts = [`M ${start.x} ${start.y}`];
  rest.forEach((corner, i) => {
    const before = points[i];
    const after = points[i + 2];
    if (before === undefined) return;
    if (after === undefined) {
      parts.push(`L ${corner.x} ${corner.y}`);
      return;
    }
    const entry = towards(corner, before, radius);
    const exit = towards(corner, after, radius);
    parts.push(`L ${entry.x} ${entry.y} Q ${corner.x} ${corner.y} ${exit.x} ${exit.y}`);
  });
  return parts.join(" ");
}

function towards(from: Point, to: Point, distance: number): Point {
  const length = Math.hypot(to.x - from.x, to.y - from.y);
  const share = length === 0 ? 0 : Math.min(distance, length / 2) / length;
  return { x: from.x + (to.x - from.x) * share, y: from.y + (to.y - from.y) * share };
}
