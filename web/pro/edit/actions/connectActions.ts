// Connecting without a mouse: a port or barrier, and a list of what it may lead to.
import { nameOfElement } from "../../../shared/edit/commands/command";
import { addTarget, connect, disconnect, targetsOf } from "../../../shared/edit/commands/connect";
import { targetNames } from "../../../shared/edit/commands/references";
import { elementOf, listOf, type Tree } from "../../../shared/edit/tree";
import { carryOut } from "../carryOut";
import { placeOfSelection } from "../gestures/onScreen";
import { ask, type MenuEntry } from "../prompt";
import type { Situation } from "../situation";
import type { Action } from "./action";
import { newId } from "../../../shared/newId";

/** The ports and barriers from which the selection can lead somewhere: a port, a barrier, all ports of a state. */
function sourcesOf({ tree, one }: Situation): readonly string[] {
  if (one === undefined) return [];
  const { kind } = elementOf(tree, one);
  return kind === "state" ? listOf(tree, one, "ports") : kind === "port" || kind === "barrier" ? [one] : [];
}

function reason(situation: Situation): string | undefined {
  const { tree, one } = situation;
  if (one === undefined) return "no port or barrier is selected";
  if (sourcesOf(situation).length === 0) return "it has no port";
  return elementOf(tree, elementOf(tree, one).kind === "port" ? elementOf(tree, one).parent : one).list === "children" ? undefined : "what it is in has no siblings";
}

/** What `from` may lead to, each as an entry. */
function targetEntries(tree: Tree, from: string, before = ""): readonly MenuEntry[] {
  const named = targetsOf(tree, from).map((to) => ({ name: `${before}${nameOfElement(tree, to)}`, run: () => void carryOut(connect(tree, from, to)) }));
  return [...named, { name: `${before}a new state`, run: () => void carryOut(addTarget(tree, from, newId)) }];
}

const connecting: Action = {
  id: "connect", name: "Connect to …", keys: ["Ctrl+L"], group: "Connect", where: "model",
  when: reason,
  run: (situation) => {
    const { tree } = situation;
    const sources = sourcesOf(situation);
    const prefix = (from: string) => (sources.length > 1 ? `${nameOfElement(tree, from)} → ` : "");
    ask({ kind: "menu", label: "Connect to", at: placeOfSelection(), entries: sources.flatMap((from) => targetEntries(tree, from, prefix(from))) });
  },
};

/** What the sources lead to, each as an entry that ends it. */
function endEntries(situation: Situation): readonly MenuEntry[] {
  const { tree } = situation;
  return sourcesOf(situation).flatMap((from) => {
    const { kind, parent } = elementOf(tree, from);
    if (kind === "port") return targetNames(tree, from).map((to) => ({ name: `${nameOfElement(tree, from)} → ${to}`, run: () => void carryOut(disconnect(tree, from)) }));
    const siblings = listOf(tree, parent, "children").filter((id) => targetNames(tree, from).includes(nameOfElement(tree, id)));
    return siblings.map((to) => ({ name: `→ ${nameOfElement(tree, to)}`, run: () => void carryOut(disconnect(tree, from, to)) }));
  });
}

const disconnecting: Action = {
  id: "disconnect", name: "Disconnect", keys: ["Ctrl+Shift+L"], group: "Connect", where: "model",
  when: (situation) => reason(situation) ?? (endEntries(situation).length === 0 ? "it leads nowhere" : undefined),
  run: (situation) => {
    const entries = endEntries(situation);
    if (entries.length === 1) entries[0]?.run();
    else ask({ kind: "menu", label: "Disconnect", at: placeOfSelection(), entries });
  },
};

export const connectActions: readonly Action[] = [connecting, disconnecting];
