// The rows of the tree of states as it is unfolded, and where keys lead in it (WAI-ARIA tree pattern).
import type { ModelTree, TreeNode } from "./modelTree";

export interface TreeRow {
  readonly entry: TreeNode;
  /** Its place among its siblings, from 1, and their number. */
  readonly position: number;
  readonly siblings: number;
  readonly open: boolean;
}

/** In the order in which they stand beneath each other. */
export function treeRows(tree: ModelTree, collapsed: ReadonlySet<string>): readonly TreeRow[] {
  const rows: TreeRow[] = [];
  const visit = (entry: TreeNode, position: number, siblings: number): void => {
    const open = entry.children.length > 0 && !collapsed.has(entry.path);
    rows.push({ entry, position, siblings, open });
    if (open) entry.children.forEach((child, i) => visit(child, i + 1, entry.children.length));
  };
  const root = tree.values().next().value;
  if (root !== undefined) visit(root, 1, 1);
  return rows;
}

/** What a key does at a row: goes to another one, or unfolds or folds it; nothing: the key means nothing there. */
export type TreeMove = { readonly to: number } | { readonly toggle: string } | undefined;

export function treeMove(rows: readonly TreeRow[], at: number, key: string, page: number): TreeMove {
  const row = rows[at];
  if (row === undefined) return undefined;
  const last = rows.length - 1;
  const { entry, open } = row;
  const composite = entry.children.length > 0;
  switch (key) {
    case "ArrowDown":
      return { to: Math.min(last, at + 1) };
    case "ArrowUp":
      return { to: Math.max(0, at - 1) };
    case "PageDown":
      return { to: Math.min(last, at + page) };
    case "PageUp":
      return { to: Math.max(0, at - page) };
    case "Home":
      return { to: 0 };
    case "End":
      return { to: last };
    case "ArrowRight":
      if (!composite) return { to: at };
      return open ? { to: at + 1 } : { toggle: entry.path };
    case "ArrowLeft":
      if (open) return { toggle: entry.path };
      return { to: Math.max(0, rows.findIndex((other) => other.entry.path === entry.parent)) };
    default:
      return undefined;
  }
}

/** The next row, after `at` and then from the first on, whose name begins with what was typed; a letter typed again goes on to the next. */
export function rowByName(rows: readonly TreeRow[], at: number, typed: string): number | undefined {
  const wanted = typed.toLowerCase();
  const from = typed.length === 1 ? at + 1 : at;
  const order = rows.map((_, i) => (from + i) % rows.length);
  return order.find((i) => rows[i]?.entry.node.name.toLowerCase().startsWith(wanted) === true);
}

/** The rows of this height [px] that are between `top` and `bottom` of the list, and some more around. */
export function rowsBetween(count: number, height: number, top: number, bottom: number): { readonly first: number; readonly end: number } {
  const kMore = 2;
  const first = Math.max(0, Math.min(count, Math.floor(top / height) - kMore));
  return { first, end: Math.max(first, Math.min(count, Math.ceil(bottom / height) + kMore)) };
}
