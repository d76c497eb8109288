// Search over a model: nodes and ports by name and by code.
import { portText } from "./describe";
import type { ModelTree } from "./modelTree";

export interface Hit {
  readonly kind: "node" | "port";
  /** Path of a node or address of a port. */
  readonly target: string;
  /** What matched, when it is not the name. */
  readonly context?: string;
}

const kMostHits = 50;

/** Names first, then code; case does not count; nothing for an empty query. */
export function search(tree: ModelTree, query: string): readonly Hit[] {
  const wanted = query.trim().toLowerCase();
  if (wanted === "") return [];
  const has = (text: string | undefined) => text?.toLowerCase().includes(wanted) === true;
  const names: Hit[] = [];
  const code: Hit[] = [];
  for (const { path, node } of tree.values()) {
    if (has(node.name)) names.push({ kind: "node", target: path });
    if (node.kind === "barrier") continue;
    for (const port of node.ports) {
      const target = `${path}.${port.name}`;
      if (has(port.name)) names.push({ kind: "port", target });
      else if (has(portText(port))) code.push({ kind: "port", target, context: portText(port) });
    }
    const texts = [node.entry, node.exit, ...node.actions.flatMap((a) => [a.when, a.do]), ...node.parameters.map((p) => p.from ?? p.name)];
    const found = texts.find(has);
    if (found !== undefined && !has(node.name)) code.push({ kind: "node", target: path, context: found });
  }
  return [...names, ...code].slice(0, kMostHits);
}
