// What a change of a time line may not change: where the other steps take their values from. A change that would is refused, as nobody would see it.
import { nameOfElement } from "../../edit/commands/command";
import { elementOf, listOf, subtree, type Tree } from "../../edit/tree";
import { referencesIn } from "../../code/references";
import { linkedState } from "../../skills/declared";
import { skillOf, supportOf } from "../../skills/skill";
import { parametersOf } from "../read";
import type { StepParameter, Value } from "../timeLine";
import { Impossible, type Draft } from "./draft";

/** What the names in a text stand for: the state that has it, and its siblings. */
function namedIn(tree: Tree, state: string, text: string): readonly (string | undefined)[] {
  const { parent } = elementOf(tree, state);
  const siblings = new Map(listOf(tree, parent, "children").map((id) => [nameOfElement(tree, id), id]));
  return referencesIn(text).map(({ names: [root, name] }) => (root === "svc" ? "" : root === "chi" ? siblings.get(name ?? "") : parent));
}

function isSame(before: Tree, was: Value, after: Tree, is: Value): boolean {
  if (was.kind === "missing") return true; // what is new in its place may give it
  if (was.kind !== is.kind) return false;
  if (was.kind === "taken") return is.kind === "taken" && is.source.step === was.source.step && is.source.result === was.source.result;
  if (was.kind === "constant") return is.kind === "constant" && is.state === was.state && is.name === was.name;
  return is.kind === "computed" && is.text === was.text && String(namedIn(before, was.state, was.text)) === String(namedIn(after, is.state, is.text));
}

type Advice = (taker: string, giver: string) => string;

/** Why a value would be another one, and what to do. */
function reasonText(tree: Tree, state: string, { about, value }: StepParameter, advice: Advice): string {
  const taker = skillOf(tree, state).title;
  if (value.kind !== "taken") return `the "${about.title}" of "${taker}" is computed from what is around it: change this in RACE Pro`;
  const giver = skillOf(tree, value.source.step).title;
  return `"${taker}" takes what "${giver}" gives: ${advice(taker, giver)}, or choose another "${about.title}" there`;
}

/** The states that link another one, but those that ask a person: what they say follows their step. */
function takers(tree: Tree): readonly string[] {
  return subtree(tree, tree.root).filter((id) => {
    const linked = elementOf(tree, id).kind === "state" ? linkedState(tree, id) : undefined;
    return linked !== undefined && supportOf(tree, linked) !== "ask";
  });
}

/**
 * Throws Impossible if a step takes one of its values from elsewhere than before. Which part `moved` takes may be another one: that is what the change is about.
 * `advice`: what to do, by the titles of the step that takes and of the one that gives.
 */
export function keepValues(before: Tree, draft: Draft, moved: string | undefined, advice: Advice): void {
  const after = draft.tree;
  for (const state of takers(before)) {
    if (!after.elements.has(state)) continue;
    const now = new Map(parametersOf(after, state).map(({ about, value }) => [about.name, value]));
    for (const parameter of parametersOf(before, state)) {
      const { about, value } = parameter;
      const is = now.get(about.name);
      const isMoved = state === moved && about.domain === "found" && value.kind === "taken";
      if (is !== undefined && !isMoved && !isSame(before, value, after, is)) throw new Impossible(reasonText(before, state, parameter, advice));
    }
  }
}
