// Tools of the canvas: the level of detail, collapse all, expand all, and those of the page (`children`).
import type { ReactNode } from "react";
import type { Detail } from "../../shared/drawing/measure";
import type { ModelTree } from "../../shared/model/modelTree";
import { keysOf } from "../../shared/session/shortcuts";
import { useSession, useView, view } from "../client";
import { hideCell, showCell, useCellPlace } from "../layout/panels";

const choices: readonly { readonly detail: Detail; readonly name: string; readonly title: string }[] = [
  { detail: "slim", name: "Names", title: "States and ports by name" },
  { detail: "ports", name: "Conditions", title: "Ports with their conditions" },
  { detail: "full", name: "Everything", title: "Parameters, results, functions and conditions" },
];

const detailOf = (value: string): Detail | undefined => choices.find(({ detail }) => detail === value)?.detail;

interface Props {
  readonly tree: ModelTree;
  readonly detail: Detail;
  readonly children: ReactNode;
}

export function CanvasTools({ tree, detail, children }: Props) {
  const collapsed = useView((v) => v.collapsed.size > 0);
  const composites = [...tree.values()].filter((entry) => entry.depth > 0 && entry.children.length > 0).map((entry) => entry.path);
  const hasCell = useSession((s) => s.cell);
  const follows = useView((v) => v.follow);
  const isRun = useView((v) => v.page === "task");
  const isCellShown = useCellPlace() !== undefined;
  return (
    <div className="canvas-tools" role="toolbar" aria-label="Drawing">
      <div className="segments" role="group" aria-label="Detail">
        {choices.map((choice) => (
          <button
            key={choice.detail}
            type="button"
            aria-pressed={detail === choice.detail}
            title={choice.title}
            onClick={() => view.dispatch({ type: "detail", detail: choice.detail })}
          >
            {choice.name}
          </button>
        ))}
      </div>
      {/* Where there is no room for the buttons. */}
      <select className="detail-choice" aria-label="Detail" value={detail} onChange={(event) => view.dispatch({ type: "detail", detail: detailOf(event.target.value) ?? detail })}>
        {choices.map((choice) => (
          <option key={choice.detail} value={choice.detail}>
            {choice.name}
          </option>
        ))}
      </select>
      {composites.length > 0 && (
        <button type="button" onClick={() => view.dispatch(collapsed ? { type: "expand_all" } : { type: "collapse_all", paths: composites })}>
          {collapsed ? "Expand all" : "Collapse all"}
        </button>
      )}
      {children}
      {isRun && (
        <button type="button" aria-pressed={follows} title={`The drawing goes to what becomes active, until you move it (${keysOf("follow")})`} onClick={() => view.dispatch({ type: "follow", on: !follows })}>
          Follow
        </button>
      )}
      {hasCell && isRun && (
        <button type="button" className="tool-cell" aria-pressed={isCellShown} onClick={() => (isCellShown ? hideCell() : showCell())}>
          Cell view
        </button>
      )}
    </div>
  );
}
