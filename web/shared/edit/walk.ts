// Going from element to element of a drawing by the arrow keys: between siblings, in, and out.
import type { Selection } from "../model/identity";
import { childPath, portAddress } from "../model/model";
import { portAt, splitAddress, type ModelTree } from "../model/modelTree";

export type Way = "previous" | "next" | "in" | "out" | "ports";

const node = (path: string): Selection => ({ kind: "node", path });
const port = (address: string): Selection => ({ kind: "port", address });

/** The item before or behind the one for which `is` holds; at the ends, that one. */
function beside<T>(items: readonly T[], is: (item: T) => boolean, way: "previous" | "next"): T | undefined {
  const at = items.findIndex(is);
  return items[Math.min(items.length - 1, Math.max(0, at + (way === "next" ? 1 : -1)))];
}

const portsOf = (tree: ModelTree, path: string): readonly string[] => {
  const at = tree.get(path)?.node;
  return at?.kind === "state" ? at.ports.map((each) => portAddress(path, each)) : [];
};

function fromPort(tree: ModelTree, address: string, way: Way): Selection | undefined {
  const owner = splitAddress(address)?.path;
  if (owner === undefined || portAt(tree, address) === undefined) return undefined;
  switch (way) {
    case "previous":
    case "next": {
      const found = beside(portsOf(tree, owner), (each) => each === address, way);
      return found === undefined ? undefined : port(found);
    }
    case "out":
      return node(owner);
    default:
      return undefined;
  }
}

/** Where a key leads from `selection`, or from nothing inside of the state `focus`; nothing: it does not. */
export function walk(tree: ModelTree, selection: Selection | undefined, focus: string, way: Way): Selection | undefined {
  if (selection?.kind === "port") return fromPort(tree, selection.address, way);
  const entry = tree.get(selection?.path ?? "");
  if (entry === undefined) {
    const first = tree.get(focus)?.children[0] ?? tree.get(focus);
    return first === undefined ? undefined : node(first.path);
  }
  const firstPort = portsOf(tree, entry.path)[0];
  switch (way) {
    case "previous":
    case "next": {
      const siblings = tree.get(entry.parent ?? "")?.children ?? [entry];
      const found = beside(siblings, ({ path }) => path === entry.path, way);
      return found === undefined ? undefined : node(found.path);
    }
    case "in": {
      const child = entry.children[0];
      return child !== undefined ? node(childPath(entry.path, child.node)) : firstPort === undefined ? undefined : port(firstPort);
    }
    case "out":
      return entry.parent === undefined ? undefined : node(entry.parent);
    case "ports":
      return firstPort === undefined ? undefined : port(firstPort);
  }
}
