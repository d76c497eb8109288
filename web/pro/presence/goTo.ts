// Going to where somebody else is in the document.
import type { PersonAt } from "../../generated/messages";
import { selectionsOf } from "../../shared/model/identity";
import { spotOfElement } from "../../shared/edit/errorMarks";
import { view } from "../client";
import { editedDocument, editedTree, editing, showTop } from "../edit/editing";

/** Shows the level that they see, and what they have selected or write in. */
export function goToPerson({ level, selection, text, pointer }: PersonAt): void {
  const document = editedDocument();
  const at = selection?.[0] ?? text?.element ?? level ?? pointer?.element;
  if (document === undefined || at === undefined || !document.elements.has(at)) return;
  const spot = spotOfElement(document, at);
  if (spot.top !== editing.get().top) showTop(spot.top);
  const model = editedTree();
  if (model === undefined) return;
  const selections = selectionsOf(model);
  const [inside, element] = [selections.get(level ?? ""), selections.get(spot.id)];
  if (inside?.kind === "node") view.dispatch({ type: "enter", path: model.get(inside.path)?.parent === undefined ? undefined : inside.path });
  if (element !== undefined && at !== level) view.dispatch({ type: "jump", selection: element });
}
