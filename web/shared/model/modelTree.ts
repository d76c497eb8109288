// Addresses of a model: every node by its path (`Root/Pick/Grasp`), every port by its address (`Root/Pick/Grasp.success`).
import { childPath, keyOf, portAddress, type Barrier, type Node, type Port, type State } from "./model";

export interface TreeNode {
  readonly path: string;
  readonly parent: string | undefined;
  readonly depth: number;
  readonly node: Node;
  readonly children: readonly TreeNode[];
}

/** All nodes of a model in tree order, by path. */
export type ModelTree = ReadonlyMap<string, TreeNode>;

export function buildTree(root: State): ModelTree {
  const found: [string, TreeNode][] = [];
  const visit = (node: Node, parent: TreeNode | undefined): TreeNode => {
    const path = parent === undefined ? node.name : childPath(parent.path, node);
    const children: TreeNode[] = [];
    const entry: TreeNode = { path, parent: parent?.path, depth: (parent?.depth ?? -1) + 1, node, children };
    found.push([path, entry]);
    if (node.kind === "state") children.push(...node.children.map((child) => visit(child, entry)));
    return entry;
  };
  visit(root, undefined);
  return new Map(found);
}

export function stateAt(tree: ModelTree, path: string): State | undefined {
  const node = tree.get(path)?.node;
  return node?.kind === "state" ? node : undefined;
}

export function barrierAt(tree: ModelTree, path: string): Barrier | undefined {
  const node = tree.get(path)?.node;
  return node?.kind === "barrier" ? node : undefined;
}

/** `Root/A.success` -> path and port name. */
export function splitAddress(address: string): { readonly path: string; readonly port: string } | undefined {
  const dot = address.lastIndexOf(".");
  return dot < 0 ? undefined : { path: address.slice(0, dot), port: address.slice(dot + 1) };
}

/** The path of a node, from its own path or the address of one of its ports. */
export const ownerOf = (end: string): string => splitAddress(end)?.path ?? end;

export function portAt(tree: ModelTree, address: string): Port | undefined {
  const parts = splitAddress(address);
  if (parts === undefined) return undefined;
  return stateAt(tree, parts.path)?.ports.find((port) => keyOf(port) === parts.port);
}

/** `Root/Pick/Grasp` -> [`Root`, `Root/Pick`, `Root/Pick/Grasp`]: the breadcrumb of a node. */
export function ancestry(path: string): readonly string[] {
  const parts = path.split("/");
  return parts.map((_, i) => parts.slice(0, i + 1).join("/"));
}

export function nameOf(path: string): string {
  return path.slice(path.lastIndexOf("/") + 1);
}

/** in(b) of Def. 3.9: all sibling ports that lead to this barrier, in declaration order. */
export function inboundPorts(tree: ModelTree, path: string): readonly string[] {
  const entry = tree.get(path);
  const siblings = entry?.parent === undefined ? [] : (tree.get(entry.parent)?.children ?? []);
  return siblings.flatMap(({ path: source, node }) =>
    node.kind === "state" ? node.ports.filter((p) => p.to === entry?.node.name).map((p) => portAddress(source, p)) : [],
  );
}
