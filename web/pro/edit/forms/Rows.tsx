// A list that is edited row by row. The handle of a row is dragged, and has the keys: Enter adds a row below, Delete removes it, Alt and
// arrows move it. The focus stays in the list.
import { useRef, type KeyboardEvent, type ReactNode } from "react";
import type { Conflicts } from "../../../shared/edit/order";
import { useRefusal } from "../../login/rights";
import { RowEnter } from "./rowEnter";
import { useRowDrag } from "./useRowDrag";
import { useRowFocus } from "./useRowFocus";

export interface RowItem {
  readonly id: string;
  readonly name: string;
  readonly content: ReactNode;
}

interface Props {
  readonly label: string;
  /** What one of them is called: "Add parameter". */
  readonly one: string;
  readonly items: readonly RowItem[];
  /** The rows of which the order matters show their numbers. */
  readonly numbered?: Conflicts;
  /** Adds one behind another, or as the last one, and says which; nothing: none can be added here. */
  readonly onAdd?: (after: string | undefined) => string | undefined;
  readonly onRemove: (id: string) => void;
  /** Nothing: their order is not the user's. */
  readonly onMove?: (id: string, to: number) => void;
  readonly className?: string;
}

const kKeys = "Drag to move, or Alt+↑ and Alt+↓. Enter adds one below, Delete removes it.";

export function Rows({ label, one, items, numbered, className, ...edits }: Props) {
  const refusal = useRefusal("edit");
  const { onAdd, onMove } = refusal === undefined ? edits : {};
  const list = useRef<HTMLUListElement>(null);
  const focus = useRowFocus(list);
  const drag = useRowDrag(list, onMove);

  const add = (after: string | undefined) => {
    const made = onAdd?.(after);
    if (made !== undefined) focus.toRow(made, "first");
  };
  const remove = (i: number) => {
    const [item, neighbour] = [items[i], items[i + 1] ?? items[i - 1]];
    if (item === undefined || refusal !== undefined) return;
    if (neighbour === undefined) focus.toAdd();
    else focus.toRow(neighbour.id, "handle");
    edits.onRemove(item.id);
  };
  const pressInRow = (event: KeyboardEvent, i: number) => {
    const by = event.key === "ArrowUp" ? -1 : event.key === "ArrowDown" ? 1 : 0;
    const item = items[i];
    if (by === 0 || !event.altKey || item === undefined || onMove === undefined) return;
    event.preventDefault();
    focus.stay();
    if (items[i + by] !== undefined) onMove(item.id, i + by);
  };
  const pressOnHandle = (event: KeyboardEvent, i: number) => {
    if (event.altKey || event.ctrlKey || event.metaKey) return;
    if (event.key === "Delete") remove(i);
    else if (event.key === "Enter") add(items[i]?.id);
    else if (event.key === "ArrowUp" || event.key === "ArrowDown") focus.toRow(items[i + (event.key === "ArrowUp" ? -1 : 1)]?.id, "handle");
    else return;
    event.preventDefault();
    event.stopPropagation();
  };

  return (
    <section className={["form-rows", className].filter(Boolean).join(" ")} aria-label={label}>
      <header>
        <h3>{label}</h3>
        {edits.onAdd !== undefined && (
          <button type="button" className="row-add" data-add aria-label={`Add ${one}`} disabled={refusal !== undefined} title={refusal ?? `Add ${one}`} onClick={() => add(items.at(-1)?.id)}>
            +
          </button>
        )}
      </header>
      {items.length > 0 && (
        <ul ref={list}>
          {items.map((item, i) => (
            <li key={item.id} data-row={item.id} className={drag.classOf(item.id)} onKeyDown={(event) => pressInRow(event, i)}>
              <button
                type="button"
                className="row-handle"
                title={refusal ?? kKeys}
                aria-label={`${one} ${item.name}, ${i + 1} of ${items.length}`}
                aria-keyshortcuts="Alt+ArrowUp Alt+ArrowDown Enter Delete"
                onKeyDown={(event) => pressOnHandle(event, i)}
                {...drag.handlersOf(item.id)}
              >
                {numbered?.has(i) === true ? <b>{i + 1}</b> : <span aria-hidden="true">⠿</span>}
              </button>
              <div className="row-content">
                <RowEnter.Provider value={onAdd && (() => add(item.id))}>{item.content}</RowEnter.Provider>
              </div>
              <button type="button" className="row-remove" tabIndex={-1} aria-label={`Remove ${one} ${item.name}`} disabled={refusal !== undefined} title={refusal ?? "Remove"} onClick={() => remove(i)}>
                ✕
              </button>
            </li>
          ))}
        </ul>
      )}
    </section>
  );
}
