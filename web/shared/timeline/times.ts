// How often a loop repeats that one of its steps has ended: no loop is left without an end by a change that is about something else.
import type { Operation } from "../edit/apply";
import { nameOfElement, type NewId } from "../edit/commands/command";
import { elementOf, listOf, type Tree } from "../edit/tree";
import { entryOf } from "../json";
import { endsLoop, isDisabled, isLoop, planOf } from "./plan";
import { partsOf } from "./read";
import { valueOf } from "./values";

/** How often a loop repeats that nothing else ends. */
export const kTimes = 3;
/** The parameter of `Repeat`; 0: for ever. */
const kCount = "times";

/** Whether a step that is on ends what repeats this body. */
export function isEnded(tree: Tree, body: string): boolean {
  const plan = planOf(tree, body);
  return "intents" in plan && [...plan.intents].some(([id, intent]) => !isDisabled(tree, id) && endsLoop(intent));
}

/** Sets how often at the counter itself, wherever the value stood. */
export function setTimes(tree: Tree, count: string, times: number, newId: NewId): readonly Operation[] {
  const own = listOf(tree, count, "parameters").find((id) => nameOfElement(tree, id) === kCount);
  const after = listOf(tree, count, "parameters").at(-1);
  if (own === undefined) return [{ op: "insert", parent: count, list: "parameters", ...(after !== undefined && { after }), node: { name: kCount, value: times, meta: { id: newId() } } }];
  const from = entryOf(elementOf(tree, own).fields, "from");
  return [...(from === undefined ? [] : [{ op: "set", id: own, field: "from" } as const]), { op: "set", id: own, field: "value", value: times }];
}

/** A loop that repeated until a step says so, and that no step ends any more, is counted. One that a person lets repeat for ever is not. */
export function settleTimes(before: Tree, after: Tree, newId: NewId): readonly Operation[] {
  return [...after.elements.keys()].flatMap((loop) => {
    const was = before.elements.has(loop) && isLoop(before, loop) ? partsOf(before, loop) : undefined;
    const is = was === undefined || !isLoop(after, loop) ? undefined : partsOf(after, loop);
    if (was === undefined || is === undefined || !isEnded(before, was.body) || isEnded(after, is.body)) return [];
    const times = valueOf(after, is.count, kCount);
    return times.kind === "constant" && times.value === 0 ? setTimes(after, is.count, kTimes, newId) : [];
  });
}
