// The hierarchy as a tree: active states are lit, a click selects and shows. Of a large one only the rows in view are in the page.
import { memo, useMemo, useRef, useState, type KeyboardEvent, type PointerEvent } from "react";
import type { ModelTree } from "../../shared/model/modelTree";
import { rowByName, treeMove, treeRows, type TreeRow } from "../../shared/model/treeRows";
import { useLiveSlowly } from "../canvas/useLive";
import { useView, view } from "../client";
import { TreeComments } from "../comments/TreeComments";
import { BreakpointDot } from "../debugger/BreakpointDot";
import { ErrorMark } from "../edit/ErrorMark";
import { followPointer } from "../edit/gestures/drag";
import { dragRow } from "../edit/gestures/dragRow";
import { TreeFaces } from "../presence/TreeFaces";
import { showRow, useFocusWhenShown } from "./showRow";
import { useRowsInView } from "./useRowsInView";

/** Height of a row, as in panels.css [px]. */
const kRow = 26;
/** A tree with no more rows is in the page as a whole. */
const kWhole = 60;
/** Keys typed within this time are one word [ms]. */
const kWord = 700;

export function StateTree({ tree }: { readonly tree: ModelTree | undefined }) {
  return (
    <section className="tree" aria-label="States">
      <h2>States</h2>
      {tree === undefined || tree.size === 0 ? <p className="quiet">No task is loaded.</p> : <Rows tree={tree} />}
    </section>
  );
}

const jump = (path: string) => view.dispatch({ type: "jump", selection: { kind: "node", path } });

/** The row with the focus, or that gets it when the tree does: the one that keys went to, else the selected one, else the first. */
function useCursor(rows: readonly TreeRow[], selected: ReadonlySet<string>) {
  const [cursor, setCursor] = useState<string>();
  const index = useMemo(() => new Map(rows.map((row, i) => [row.entry.path, i])), [rows]);
  const [first] = selected;
  const at = index.get(cursor ?? "") ?? index.get(first ?? "") ?? 0;
  return { at, setCursor };
}

function Rows({ tree }: { readonly tree: ModelTree }) {
  const list = useRef<HTMLUListElement>(null);
  const collapsed = useView((v) => v.collapsed);
  const selection = useView((v) => v.selection);
  const also = useView((v) => v.also);
  const active = useLiveSlowly((live) => live.active);
  const rows = useMemo(() => treeRows(tree, collapsed), [tree, collapsed]);
  const selected = useMemo(() => new Set(selection?.kind === "node" ? [selection.path, ...also] : []), [selection, also]);
  const { at, setCursor } = useCursor(rows, selected);
  const inView = useRowsInView(list, ".side", rows.length, kRow);
  const { first, end } = rows.length <= kWhole ? { first: 0, end: rows.length } : inView;
  const focusWhenShown = useFocusWhenShown(list);
  const typedRef = useRef({ text: "", at: -Infinity });

  const go = (to: number) => {
    const path = rows[to]?.entry.path;
    if (path === undefined) return;
    focusWhenShown(`[data-path="${CSS.escape(path)}"]`);
    setCursor(path);
    showRow(list.current, ".side", to, kRow, 1);
  };
  const press = (event: KeyboardEvent) => {
    if (event.ctrlKey || event.metaKey || event.altKey || event.target instanceof HTMLButtonElement) return;
    const path = rows[at]?.entry.path;
    const move = treeMove(rows, at, event.key, 10);
    if (move !== undefined) {
      if ("to" in move) go(move.to);
      else view.dispatch({ type: "toggle", path: move.toggle });
    } else if (event.key === "Enter" && path !== undefined) jump(path);
    else if (/^\w$/.test(event.key)) {
      const typed = typedRef.current;
      const text = event.timeStamp - typed.at < kWord ? typed.text + event.key : event.key;
      typedRef.current = { text, at: event.timeStamp };
      const found = rowByName(rows, at, text);
      if (found !== undefined) go(found);
    } else return;
    event.preventDefault();
    event.stopPropagation();
  };
  const shown = rows.slice(first, end);
  // The row with the focus stays in the page, else the focus would be lost.
  const outside = rows[at] !== undefined && (at < first || at >= end) ? rows[at] : undefined;
  return (
    <ul role="tree" aria-label="State tree" ref={list} style={{ height: rows.length * kRow }} onKeyDown={press} onFocus={({ target }) => setCursor(target.closest("li")?.dataset["path"])}>
      {[...shown, ...(outside === undefined ? [] : [outside])].map((row, i) => {
        const { path } = row.entry;
        const index = row === outside ? at : first + i;
        return <Row key={path} row={row} index={index} active={active.has(path)} selected={selected.has(path)} tabbable={index === at} />;
      })}
    </ul>
  );
}

interface RowProps {
  readonly row: TreeRow;
  readonly index: number;
  readonly active: boolean;
  readonly selected: boolean;
  readonly tabbable: boolean;
}

/** A row of a document that is edited can be dragged; a finger scrolls the list. */
function drag(event: PointerEvent, path: string): void {
  const isOfRow = event.button === 0 && event.pointerType !== "touch" && event.target instanceof Element && event.target.closest(".tree-fold") === null;
  if (isOfRow && view.get().page === "edit") followPointer(event, () => dragRow(path));
}

const Row = memo(function Row({ row: { entry, position, siblings, open }, index, active, selected, tabbable }: RowProps) {
  const { path, depth, node } = entry;
  const composite = entry.children.length > 0;
  return (
    <li
      role="treeitem"
      className={composite ? "tree-row" : node.kind === "barrier" ? "tree-row is-bar" : "tree-row is-leaf"}
      aria-label={path}
      aria-level={depth + 1}
      aria-posinset={position}
      aria-setsize={siblings}
      aria-selected={selected}
      aria-expanded={composite ? open : undefined}
      data-active={active}
      data-path={path}
      tabIndex={tabbable ? 0 : -1}
      style={{ top: index * kRow, paddingLeft: 8 + depth * 14 }}
      onPointerDown={(event) => drag(event, path)}
    >
      {composite && (
        <button type="button" className="tree-fold" tabIndex={-1} aria-label={`${open ? "Collapse" : "Expand"} ${node.name}`} onClick={() => view.dispatch({ type: "toggle", path })}>
          {open ? "▾" : "▸"}
        </button>
      )}
      <button type="button" className="tree-name" tabIndex={-1} onClick={() => jump(path)}>
        {node.name}
      </button>
      <BreakpointDot path={path} closed={composite && !open} />
      <TreeFaces path={path} closed={composite && !open} />
      <TreeComments path={path} closed={composite && !open} />
      <ErrorMark path={path} closed={composite && !open} />
    </li>
  );
});
