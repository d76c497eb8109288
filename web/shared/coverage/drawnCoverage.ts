// The signs of coverage in a drawing: for each state and port that no test has come to, and each state of which conditions were seen in part.
import type { Box } from "../drawing/drawing";
import { portAddress } from "../model/model";
import type { TreeNode } from "../model/modelTree";
import type { DrawnModel } from "../versions/ghosts";
import type { CoverageMark } from "./coverage";
import { insideText } from "./texts";

export interface DrawnCoverage extends CoverageMark {
  /** The path of a state, or the address of a port. */
  readonly address: string;
  readonly of: "state" | "port";
  readonly box: Box;
}

type Marks = ReadonlyMap<string, CoverageMark>;

const markOf = (marks: Marks, id: string | undefined): CoverageMark | undefined => (id === undefined ? undefined : marks.get(id));

/** States and ports in a state, without its own, that are never active or fired. */
function neverInside(marks: Marks, at: TreeNode): number {
  const isNever = (id: string | undefined): 0 | 1 => (markOf(marks, id)?.kind === "never" ? 1 : 0);
  return at.children.reduce((sum, child) => {
    const ports = child.node.kind === "state" ? child.node.ports : [];
    return sum + isNever(child.node.id) + ports.reduce((all, port) => all + isNever(port.id), 0) + neverInside(marks, child);
  }, 0);
}

/** A state that is drawn closed tells also what is missing in it. */
export function drawnCoverage(marks: Marks, { drawing, tree }: DrawnModel): readonly DrawnCoverage[] {
  return drawing.nodes.flatMap((node): readonly DrawnCoverage[] => {
    const entry = tree.get(node.path);
    if (entry?.node.kind !== "state") return [];
    const own = markOf(marks, entry.node.id);
    const inside = node.composite && !node.open && own?.kind !== "never" ? neverInside(marks, entry) : 0;
    const mark: CoverageMark | undefined = inside === 0 ? own : { kind: "partly", text: [...(own === undefined ? [] : [own.text]), insideText(inside)].join("; ") };
    const idOf = new Map(entry.node.ports.map((port) => [portAddress(node.path, port), port.id]));
    return [
      ...(mark === undefined ? [] : [{ ...mark, address: node.path, of: "state" as const, box: node }]),
      ...node.ports.flatMap((port) => {
        const made = markOf(marks, idOf.get(port.address));
        return made === undefined ? [] : [{ ...made, address: port.address, of: "port" as const, box: port }];
      }),
    ];
  });
}
