// Dashed stubs: they mark ports without a destination that no condition of the parent names.
import type { DrawnLine, DrawnNode, DrawnPort, Drawing } from "./drawing";

const kStub = 22;
const made = new WeakMap<DrawnPort, DrawnLine>();

/** The same line for the same port. */
function stubOf(node: DrawnNode, port: DrawnPort): DrawnLine {
  const known = made.get(port);
  if (known !== undefined) return known;
  const east = node.side === "EAST";
  const start = east ? { x: port.x + port.width, y: port.y + port.height / 2 } : { x: port.x + port.width / 2, y: port.y + port.height };
  const end = east ? { x: start.x + kStub, y: start.y } : { x: start.x, y: start.y + kStub };
  const stub: DrawnLine = { id: `${port.address}→`, kind: "nowhere", from: port.address, to: undefined, depth: node.depth, points: [start, end] };
  made.set(port, stub);
  return stub;
}

/** One stub for each port that neither leads on nor is named by its parent. */
export function stubs(drawing: Drawing): readonly DrawnLine[] {
  const connected = new Set(drawing.lines.map((line) => line.from));
  return drawing.nodes.flatMap((node) => node.ports.filter((port) => port.exits && !connected.has(port.address)).map((port) => stubOf(node, port)));
}
