// The hierarchy as a tree: active states are lit, a click selects and shows.
import { useMemo } from "react";
import type { ModelTree, TreeNode } from "../../shared/model/modelTree";
import { ErrorMark } from "../edit/ErrorMark";
import { useSession, useView, view } from "../client";

export function StateTree({ tree }: { readonly tree: ModelTree | undefined }) {
  const root = tree?.values().next().value;
  return (
    <section className="tree" aria-label="States">
      <h2>States</h2>
      {root === undefined ? (
        <p className="quiet">No task is loaded.</p>
      ) : (
        <ul role="tree" aria-label="State tree">
          <Item entry={root} />
        </ul>
      )}
    </section>
  );
}

function Item({ entry }: { readonly entry: TreeNode }) {
  const run = useSession((s) => s.run);
  const active = useMemo(() => run?.active.includes(entry.path) === true, [run, entry.path]);
  const selected = useView((v) => (v.selection?.kind === "node" && v.selection.path === entry.path) || v.also.has(entry.path));
  const collapsed = useView((v) => v.collapsed.has(entry.path));
  const composite = entry.children.length > 0;
  return (
    <li role="treeitem" aria-selected={selected} aria-expanded={composite ? !collapsed : undefined} aria-label={entry.path} data-active={active}>
      <div className="tree-row" data-path={entry.path} style={{ paddingLeft: 8 + entry.depth * 14 }}>
        {composite ? (
          <button
            type="button"
            className="tree-fold"
            aria-label={`${collapsed ? "Expand" : "Collapse"} ${entry.node.name}`}
            onClick={() => view.dispatch({ type: "toggle", path: entry.path })}
          >
            {collapsed ? "▸" : "▾"}
          </button>
        ) : (
          <span className={entry.node.kind === "barrier" ? "tree-bar" : "tree-leaf"} aria-hidden="true" />
        )}
        <button type="button" className="tree-name" onClick={() => view.dispatch({ type: "jump", selection: { kind: "node", path: entry.path } })}>
          {entry.node.name}
        </button>
        <ErrorMark path={entry.path} closed={composite && collapsed} />
        {active && <i className="dot" title="active" />}
      </div>
      {composite && !collapsed && (
        <ul role="group">
          {entry.children.map((child) => (
            <Item key={child.path} entry={child} />
          ))}
        </ul>
      )}
    </li>
  );
}
