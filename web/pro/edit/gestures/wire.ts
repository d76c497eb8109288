// Dragging from a port or barrier to what it shall lead to.
import { addTarget, connect, reasonAgainstTarget, targetsOf } from "../../../shared/edit/commands/connect";
import { elementOf } from "../../../shared/edit/tree";
import { idAt, selectionsOf, type Selection } from "../../../shared/model/identity";
import { ancestry } from "../../../shared/model/modelTree";
import { pathOf } from "../../../shared/session/view";
import { newId } from "../../../shared/newId";
import { refusalNow } from "../../login/rights";
import { carryOut } from "../carryOut";
import { editedDocument } from "../editing";
import { ask, type ScreenPoint } from "../prompt";
import { situationNow, type Situation } from "../situation";
import type { Drag } from "./drag";
import { boxOf, drawnNodes, hitAt, isOnDrawing } from "./onScreen";
import { showDrag } from "./shown";

/** Where a line would end: at an element; on the background, where a new state can be made; or nowhere, for a reason. */
type End = { readonly kind: "element"; readonly id: string; readonly path: string } | { readonly kind: "background" } | { readonly kind: "nowhere"; readonly reason?: string };

class Wire implements Drag {
  private readonly dimmed: readonly DOMRect[];

  constructor(
    private readonly situation: Situation,
    private readonly from: string,
    private readonly source: Selection,
    private readonly start: ScreenPoint,
  ) {
    const { model, tree } = situation;
    const targets = new Set(targetsOf(tree, from).map((id) => this.pathOf(id)));
    const around = new Set(ancestry(pathOf(source)));
    const isTarget = (path: string) => ancestry(path).some((part) => targets.has(part));
    this.dimmed = drawnNodes().filter(({ path }) => model.has(path) && !around.has(path) && !isTarget(path)).map(({ box }) => box);
  }

  private pathOf(id: string): string {
    const found = selectionsOf(this.situation.model).get(id);
    return found === undefined ? "" : pathOf(found);
  }

  private endAt(at: ScreenPoint): End {
    const { tree, model } = this.situation;
    if (!isOnDrawing(at)) return { kind: "nowhere" };
    const hit = hitAt(at);
    if (hit !== undefined && idAt(model, hit) === this.from) return { kind: "nowhere" };
    const composite = model.get(model.get(pathOf(this.source))?.parent ?? "")?.path;
    const path = hit === undefined ? undefined : pathOf(hit);
    if (path === undefined || composite === undefined || ancestry(composite).includes(path)) return composite === undefined ? { kind: "nowhere", reason: "what it is in has no siblings" } : { kind: "background" };
    const reasons = [...ancestry(path)].reverse().map((part) => ({ part, id: model.get(part)?.node.id ?? "", reason: reasonAgainstTarget(tree, this.from, model.get(part)?.node.id ?? "") }));
    const found = reasons.find(({ reason }) => reason === undefined);
    if (found !== undefined) return { kind: "element", id: found.id, path: found.part };
    const [innermost] = reasons;
    return innermost?.reason === undefined ? { kind: "nowhere" } : { kind: "nowhere", reason: innermost.reason };
  }

  move(to: ScreenPoint): void {
    const end = this.endAt(to);
    const text = end.kind === "nowhere" ? end.reason : undefined;
    showDrag({
      line: { from: this.start, to },
      dimmed: this.dimmed,
      target: end.kind === "element" ? boxOf({ kind: "node", path: end.path }) : undefined,
      text: text === undefined ? undefined : { at: to, text, refused: true },
    });
  }

  drop(at: ScreenPoint): void {
    const end = this.endAt(at);
    const tree = editedDocument();
    if (tree?.elements.has(this.from) !== true) return;
    if (end.kind === "element") carryOut(connect(tree, this.from, end.id));
    if (end.kind === "background") this.askForState(at);
  }

  private askForState(at: ScreenPoint): void {
    const make = () => {
      const tree = editedDocument();
      if (tree?.elements.has(this.from) === true) carryOut(addTarget(tree, this.from, newId));
    };
    ask({ kind: "menu", label: "Lead to", at, entries: [{ name: "New state here", run: make }, { name: "Cancel", run: () => undefined }] });
  }

  end(): void {
    showDrag(undefined);
  }
}

/** The drag of a line from this port or barrier; nothing: no line begins there. */
export function wireFrom(source: Selection): Drag | undefined {
  if (refusalNow("edit") !== undefined) return undefined;
  const situation = situationNow();
  const from = situation && idAt(situation.model, source);
  const box = boxOf(source);
  if (situation === undefined || from === undefined || box === undefined || elementOf(situation.tree, from).kind === "state") return undefined;
  return new Wire(situation, from, source, { x: box.x + box.width / 2, y: box.y + box.height / 2 });
}
