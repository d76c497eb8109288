// States and barriers as they are drawn, alone.
import { portText } from "../model/describe";
import { portAddress, type Node, type State } from "../model/model";
import type { Block } from "./block";
import type { Box, DrawnNode, DrawnPort, Side } from "./drawing";
import { badgeText, barrierSize, conditionText, drawnLines, leafBoxes, type Detail, type Size } from "./measure";

interface Detailed {
  readonly detail: Detail;
}

/** A node that is drawn without children, as a block. */
export function leaf({ detail }: Detailed, node: Node, path: string, side: Side, depth: number): Block {
  if (node.kind === "barrier") {
    const size = barrierSize(side);
    const drawn: DrawnNode = {
      kind: "barrier", path, name: node.name, depth, x: 0, y: 0, ...size, composite: false, open: false, lines: [], ports: [], side,
    };
    return { size, ports: [], nodes: [drawn], lines: [] };
  }
  const { size, ports } = leafBoxes(node, side, detail);
  return { size, ports, nodes: [drawState({ detail }, node, path, side, depth, size, ports, false)], lines: [] };
}

/** A state whose size and ports are known, at the origin. */
export function drawState(
  { detail }: Detailed,
  state: State,
  path: string,
  side: Side,
  depth: number,
  size: Size,
  boxes: readonly Box[],
  open: boolean,
): DrawnNode {
  const ports = state.ports.flatMap((port, i): DrawnPort[] => {
    const box = boxes[i];
    if (box === undefined) return [];
    const condition = detail === "slim" ? "" : conditionText(port);
    const timed = port.after !== undefined;
    return [{ ...box, address: portAddress(path, port), name: port.name, condition, when: portText(port), timed, exits: port.to === undefined }];
  });
  const badge = badgeText(state);
  const dispatcher = state.dispatcher === undefined ? {} : { dispatcher: state.dispatcher };
  return {
    kind: "state", path, name: state.name, depth, x: 0, y: 0, ...size, composite: state.children.length > 0, open,
    lines: drawnLines(state, detail), ports, side, ...(badge === undefined ? {} : { badge }), ...dispatcher,
  };
}
