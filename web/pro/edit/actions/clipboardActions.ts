// Copy, cut and paste, by the clipboard of the system: a text that also an editor, another document and another server take. And duplicates.
import { copyText } from "../../../shared/edit/clipboard/copy";
import { duplicates } from "../../../shared/edit/clipboard/duplicates";
import { isExactObject } from "../../../shared/edit/clipboard/json";
import { paste } from "../../../shared/edit/clipboard/paste";
import { duplicate } from "../../../shared/edit/commands/group";
import { remove } from "../../../shared/edit/commands/remove";
import { readExact, type ExactJson } from "../../../shared/edit/exact";
import type { Tree } from "../../../shared/edit/tree";
import { api, problem } from "../../client";
import { carryOut, selectIds } from "../carryOut";
import { editedDocument } from "../editing";
import { refuse, tellDone } from "../say";
import { situationNow, type Situation } from "../situation";
import { whenStored } from "../whenStored";
import type { Action } from "./action";
import { newId } from "../../../shared/newId";

/** The document as the server stores it, with all edits of this page. */
async function storedDocument(name: string): Promise<{ readonly document: ExactJson; readonly tree: Tree } | { readonly reason: string }> {
  const stored = await whenStored();
  if ("reason" in stored) return stored;
  const entry = readExact(await api.documentText(name));
  const tree = editedDocument();
  return tree === undefined ? { reason: "the document is not here" } : { document: isExactObject(entry) ? (entry["document"] ?? null) : null, tree };
}

/** Whether the text of these elements, as the server stores them, is on the clipboard. */
async function copy({ document: name, ids }: Situation): Promise<boolean> {
  try {
    const stored = await storedDocument(name);
    const copied = "reason" in stored ? stored : copyText(stored.document, stored.tree, ids);
    if ("reason" in copied) {
      refuse(copied.reason);
      return false;
    }
    if (!isSecureContext) {
      refuse("the browser lets a page write the clipboard over https, or on this computer, only");
      return false;
    }
    await navigator.clipboard.writeText(copied.text);
    return true;
  } catch (error) {
    problem(error);
    return false;
  }
}

async function copyAndTell(situation: Situation): Promise<void> {
  if (await copy(situation)) tellDone("Copied.");
}

async function cut(situation: Situation): Promise<void> {
  const tree = (await copy(situation)) ? editedDocument() : undefined;
  if (tree !== undefined) carryOut(remove(tree, situation.ids));
}

/** Adds what a text has where something new would go. */
export function pasteText(text: string): void {
  const situation = situationNow();
  if (situation !== undefined) carryOut(paste(situation.tree, situation.node ?? situation.focus.id, text, newId));
}

/** Of one, the server makes the copy; copies of several are one edit. */
async function duplicateAll({ document: name, tree, ids, one }: Situation): Promise<void> {
  if (one !== undefined) {
    carryOut(duplicate(tree, one));
    return;
  }
  try {
    const stored = await storedDocument(name);
    const command = "reason" in stored ? stored : duplicates(stored.document, stored.tree, ids, newId);
    if (carryOut(command) && "made" in command) selectIds(command.made);
  } catch (error) {
    problem(error);
  }
}

async function pasteClipboard(): Promise<void> {
  try {
    pasteText(await navigator.clipboard.readText());
  } catch {
    refuse("the browser does not let the page read the clipboard: press Ctrl+V in the drawing");
  }
}

const somethingSelected = ({ ids }: Situation): string | undefined => (ids.length === 0 ? "nothing is selected" : undefined);

export const clipboardActions: readonly Action[] = [
  {
    id: "duplicate", name: "Duplicate", keys: ["Ctrl+D"], group: "Edit", where: "model",
    when: ({ tree, ids }) => (ids.length === 0 ? "nothing is selected" : ids.includes(tree.root) ? "a document has one root" : undefined),
    run: (situation) => void duplicateAll(situation),
  },
  { id: "copy", name: "Copy", keys: ["Ctrl+C"], group: "Edit", where: "model", when: somethingSelected, run: (situation) => void copyAndTell(situation) },
  {
    id: "cut", name: "Cut", keys: ["Ctrl+X"], group: "Edit", where: "model",
    when: ({ tree, ids }) => {
      const command = remove(tree, ids);
      return "reason" in command ? command.reason : undefined;
    },
    run: (situation) => void cut(situation),
  },
  // Its key is the browser's, which gives the page the text without asking.
  { id: "paste", name: "Paste", keys: ["Ctrl+V"], group: "Edit", where: "page", when: () => undefined, run: () => void pasteClipboard() },
];
