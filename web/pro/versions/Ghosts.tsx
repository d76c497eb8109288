// Removed states and barriers in the drawing of a comparison: dashed and struck, where they were before.
import { useEffect, useMemo, useState } from "react";
import { layoutModel } from "../../shared/drawing/layout";
import { placesIn } from "../../shared/drawing/places";
import { editedModel } from "../../shared/edit/editedModel";
import type { Compared } from "../../shared/edit/difference/compare";
import { idAt, selectionsOf } from "../../shared/model/identity";
import { buildTree, stateAt } from "../../shared/model/modelTree";
import { ghostsOf, removedNodes, type DrawnModel } from "../../shared/versions/ghosts";
import { layoutInWorkers } from "../canvas/layoutEngine";
import type { Laid } from "../canvas/useDrawing";

/** More would hide the drawing. */
const kMost = 40;
/** The version before is laid out for them: not if it is larger. */
const kLargest = 400;

/** The version before, drawn as `laid` is. */
async function drawBefore({ before }: Compared, { tree, drawing, detail, shows }: Laid, signal: AbortSignal): Promise<DrawnModel | undefined> {
  const was = buildTree(editedModel(before).root);
  const selections = selectionsOf(was);
  /** The same state in it. */
  const pathOf = (path: string): readonly string[] => {
    const id = idAt(tree, { kind: "node", path });
    const found = id === undefined ? undefined : selections.get(id);
    return found?.kind === "node" ? [found.path] : [];
  };
  const [path] = pathOf(shows.focus ?? tree.keys().next().value ?? "");
  const state = path === undefined ? undefined : stateAt(was, path);
  if (path === undefined || state === undefined || was.size > kLargest) return undefined;
  const collapsed = new Set([...shows.collapsed].flatMap(pathOf));
  const places = placesIn(before.fields["layout"]);
  return { tree: was, drawing: await layoutModel(layoutInWorkers(signal), { state, path, collapsed, places, detail, aspect: drawing.width / drawing.height, signal }) };
}

export function Ghosts({ compared, laid }: { readonly compared: Compared; readonly laid: Laid }) {
  const [was, setWas] = useState<{ readonly of: Compared; readonly drawn: DrawnModel }>();
  const isNeeded = useMemo(() => removedNodes(compared).length > 0, [compared]);
  useEffect(() => {
    if (!isNeeded) return;
    const end = new AbortController();
    // Without it, the signs say what was removed.
    drawBefore(compared, laid, end.signal).then((drawn) => drawn !== undefined && !end.signal.aborted && setWas({ of: compared, drawn }), () => undefined);
    return () => end.abort();
  }, [compared, laid, isNeeded]);
  const ghosts = useMemo(() => (was?.of === compared ? ghostsOf(compared, was.drawn, laid).slice(0, kMost) : []), [compared, laid, was]);
  return ghosts.map(({ id, name, kind, x, y, width, height }) => (
    <span key={id} role="img" className={`difference-ghost is-${kind}`} data-ghost={id} aria-label={`Removed: ${kind} ${name}`} style={{ left: x, top: y, width, height }}>
      {kind === "state" && <s>{name}</s>}
    </span>
  ));
}
