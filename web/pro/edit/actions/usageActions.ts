// Finding where the document names what is selected, or what the name under the cursor stands for.
import { referentAt, type Referent } from "../../../shared/code/referent";
import { nameOfElement } from "../../../shared/edit/commands/command";
import type { Tree } from "../../../shared/edit/tree";
import { cursorOf } from "../../code/cursor";
import { codeFieldOf } from "../forms/CodeInput";
import { takeFocused } from "../gestures/focused";
import { refuse } from "../say";
import { situationNow } from "../situation";
import { showUsages } from "../usages/shown";
import type { Action } from "./action";

type Found = Referent | { readonly reason: string };

/** An element that has no name stands for what it is in. */
function elementNamed(tree: Tree, id: string): Found {
  if (!tree.elements.has(id)) return { reason: "it is not in the document" };
  return nameOfElement(tree, id) === "" ? { reason: "it has no name" } : { kind: "element", id };
}

/** What the field that has the focus is about; nothing: none has. */
function ofField(tree: Tree): Found | undefined {
  const focused = document.activeElement;
  const place = focused?.closest<HTMLElement>("[data-place]")?.dataset["place"];
  const row = focused?.closest<HTMLElement>("[data-row]")?.dataset["row"];
  if (focused === null || (place === undefined && row === undefined)) return undefined;
  const [id = "", field = ""] = [place?.slice(0, place.indexOf("/")), place?.slice(place.indexOf("/") + 1)];
  const [code, cursor] = [codeFieldOf(field), cursorOf(focused)];
  if (code !== undefined && cursor !== undefined) return referentAt(tree, { id, field: code }, cursor.text(), cursor.position()) ?? { reason: "no name of the document is under the cursor" };
  if (id !== "") return elementNamed(tree, id);
  return row === undefined ? undefined : tree.elements.has(row) ? elementNamed(tree, row) : { kind: "service", key: row };
}

function find(): Found {
  takeFocused();
  const situation = situationNow();
  if (situation === undefined) return { reason: "the document is not here" };
  const { tree, one, ids } = situation;
  return ofField(tree) ?? (one === undefined ? { reason: ids.length > 1 ? "several are selected" : "nothing is selected" } : elementNamed(tree, one));
}

export const usageActions: readonly Action[] = [
  {
    id: "usages", name: "Find usages", keys: ["Shift+F12"], group: "Walk", where: "anywhere",
    when: () => undefined,
    run: () => {
      const found = find();
      if ("reason" in found) refuse(found.reason);
      else showUsages(found);
    },
  },
];
