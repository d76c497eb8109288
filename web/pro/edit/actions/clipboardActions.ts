// Copy, cut and paste, by the clipboard of the system: a text that also an editor, another document and another server take.
import { copyText } from "../../../shared/edit/clipboard/copy";
import { isExactObject } from "../../../shared/edit/clipboard/json";
import { paste } from "../../../shared/edit/clipboard/paste";
import { remove } from "../../../shared/edit/commands/remove";
import { readExact } from "../../../shared/edit/exact";
import { api, problem } from "../../client";
import { carryOut } from "../carryOut";
import { editedDocument } from "../editing";
import { refuse, tellDone } from "../say";
import { situationNow, type Situation } from "../situation";
import { whenStored } from "../whenStored";
import type { Action } from "./action";
import { newId } from "./commandAction";

/** Whether the text of these elements, as the server stores them, is on the clipboard. */
async function copy({ document: name, ids }: Situation): Promise<boolean> {
  const stored = await whenStored();
  const tree = editedDocument();
  if ("reason" in stored || tree === undefined) {
    refuse("reason" in stored ? stored.reason : "the document is not here");
    return false;
  }
  try {
    const entry = readExact(await api.documentText(name));
    const copied = copyText(isExactObject(entry) ? (entry["document"] ?? null) : null, tree, ids);
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

async function pasteClipboard(): Promise<void> {
  try {
    pasteText(await navigator.clipboard.readText());
  } catch {
    refuse("the browser does not let the page read the clipboard: press Ctrl+V in the drawing");
  }
}

const somethingSelected = ({ ids }: Situation): string | undefined => (ids.length === 0 ? "nothing is selected" : undefined);

export const clipboardActions: readonly Action[] = [
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
