// Renaming what is selected, or what the name under the cursor stands for, and finding where the document names it.
import { referentAt, type Referent } from "../../../shared/code/referent";
import { nameOfElement, type Command } from "../../../shared/edit/commands/command";
import { rename, renameService } from "../../../shared/edit/commands/rename";
import type { Tree } from "../../../shared/edit/tree";
import { cursorOf } from "../../code/cursor";
import { carryOut } from "../carryOut";
import { editedDocument } from "../editing";
import { codeFieldOf } from "../forms/CodeInput";
import { takeFocused } from "../gestures/focused";
import { placeOfSelection } from "../gestures/onScreen";
import { ask } from "../prompt";
import { refuse } from "../say";
import { situationNow, type Situation } from "../situation";
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

/** Asks another name there, and carries out the command that it makes. */
function askAnother(value: string, at: Pick<DOMRect, "x" | "y" | "width">, make: (tree: Tree, name: string) => Command): void {
  const commit = (name: string): string | undefined => {
    if (name === value) return undefined;
    const now = editedDocument();
    const command = now === undefined ? { reason: "the document is not here" } : make(now, name);
    if ("reason" in command) return command.reason;
    carryOut(command);
    return undefined;
  };
  ask({ kind: "name", label: `Name of ${value}`, at, value, commit });
}

/** Asks another name where the element is: at what is selected, or at another place of the screen. */
export const askName = ({ tree }: Situation, id: string, at: Pick<DOMRect, "x" | "y" | "width"> = placeOfSelection()): void =>
  askAnother(nameOfElement(tree, id), at, (now, name) => rename(now, id, name));

/** Of a text, where it is named is the place to ask; what is not sent of it is sent before. */
function renameFound(found: Referent, situation: Situation): void {
  const field = document.activeElement?.closest<HTMLElement>("[data-place]")?.getBoundingClientRect();
  const at = field === undefined ? placeOfSelection() : { x: field.x, y: field.bottom, width: Math.min(260, field.width) };
  if (found.kind === "element") askName(situation, found.id, at);
  else if (found.kind === "variable") refuse(`the variable ${found.name} is not declared: declare it, and it is renamed everywhere`);
  else if (found.member !== undefined) refuse("what a service has is named by the service");
  else askAnother(found.key, at, (_, name) => renameService(found.key, name));
}

export const nameActions: readonly Action[] = [
  {
    id: "rename", name: "Rename", keys: ["F2"], group: "Edit", where: "anywhere",
    when: () => undefined,
    run: (situation) => {
      const found = find();
      if ("reason" in found) refuse(found.reason);
      else renameFound(found, situation);
    },
  },
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
