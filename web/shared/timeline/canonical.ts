// What a document says of a task whose steps mean `intents`: the operations that make it say so. A document for which there are none has the
// form of api/skills.md; so the same function writes the form and recognises it.
import type { Operation } from "../edit/apply";
import { nameOfElement, type NewId } from "../edit/commands/command";
import { withoutCommentsOn } from "../edit/comments/write";
import { elementOf, listOf, type Tree } from "../edit/tree";
import { entryOf } from "../json";
import { declaredIn, metaOf, textOf } from "../skills/declared";
import { conditionTerm, isDisabled, kLeaves, loopOf, portsOf, targetOf, termsOf, type Intent, type PlannedStep } from "./plan";
import type { Then } from "./timeLine";

/** The name of a sibling; nothing: nowhere. */
type Target = string | undefined;

/** What makes the port of a child lead there. Ports of links are made where they have none. */
function leadTo(tree: Tree, state: string, port: string, to: Target, newId: NewId): readonly Operation[] {
  const declared = declaredIn(tree, state, "ports").find(({ name }) => name === port);
  if (declared === undefined || targetOf(declared) === to) return [];
  if (declared.own !== undefined) return [{ op: "set", id: declared.own, field: "to", ...(to !== undefined && { value: to }) }];
  const after = listOf(tree, state, "ports").at(-1);
  return to === undefined ? [] : [{ op: "insert", parent: state, list: "ports", ...(after !== undefined && { after }), node: { name: port, to, meta: { id: newId() } } }];
}

/** `when` of a port of the composite; the port is made if it is not there. */
function becomes(tree: Tree, composite: string, port: string, terms: readonly string[], newId: NewId): readonly Operation[] {
  const value = terms.length === 0 ? "False" : terms.join(" or ");
  const id = listOf(tree, composite, "ports").find((each) => nameOfElement(tree, each) === port);
  if (id === undefined) {
    const after = listOf(tree, composite, "ports").at(-1);
    return [{ op: "insert", parent: composite, list: "ports", ...(after !== undefined && { after }), node: { name: port, when: value, meta: { id: newId() } } }];
  }
  const now = termsOf(tree, composite, port);
  return now !== undefined && now.size === new Set(terms).size && terms.every((term) => now.has(term)) ? [] : [{ op: "set", id, field: "when", value }];
}

/** Whether an outcome goes on to the next step is marked where there is none, so that it does when there is one. */
function markNext(tree: Tree, state: string, port: string, marked: boolean, newId: NewId): readonly Operation[] {
  const own = listOf(tree, state, "ports").find((id) => nameOfElement(tree, id) === port);
  if (own !== undefined) return (metaOf(tree, own)["next"] === true) === marked ? [] : [{ op: "set", id: own, field: "meta", key: "next", ...(marked && { value: true }) }];
  const after = listOf(tree, state, "ports").at(-1);
  return marked ? [{ op: "insert", parent: state, list: "ports", ...(after !== undefined && { after }), node: { name: port, meta: { id: newId(), next: true } } }] : [];
}

/** What a task says: its steps in their order. */
export function settleTask(tree: Tree, composite: string, steps: readonly PlannedStep[], intents: ReadonlyMap<string, Intent>, newId: NewId): readonly Operation[] {
  const operations: Operation[] = [];
  const [succeeds, stops, leaves]: [string[], string[], string[]] = [[], [], []];
  const enabled = steps.filter(({ id }) => !isDisabled(tree, id));
  for (const [i, { id }] of steps.entries()) {
    const intent = intents.get(id);
    if (intent === undefined) continue;
    const name = nameOfElement(tree, id);
    const isOn = !isDisabled(tree, id);
    const following = steps.slice(i + 1).find((each) => !isDisabled(tree, each.id));
    const next: Target = following === undefined ? undefined : nameOfElement(tree, following.id);
    const handler = (of: string | undefined): Target => (of === undefined ? undefined : nameOfElement(tree, of));
    const lead = (state: string, port: string, to: Target, ends: string[] | undefined) => {
      operations.push(...leadTo(tree, state, port, to, newId));
      if (to === undefined && ends !== undefined && (isOn || ends !== succeeds)) ends.push(conditionTerm(nameOfElement(tree, state), port));
    };
    const fail = (state: string, port: string, then: Then) => {
      if (then === "ask") lead(state, port, handler(intent.ask), undefined);
      else if (then === "next") lead(state, port, next, succeeds);
      else lead(state, port, undefined, then === "leave" ? leaves : stops);
    };
    const { nominal, outcomes, errors } = portsOf(tree, id);
    if (nominal !== undefined) lead(id, nominal, next, succeeds);
    for (const { name: port } of outcomes) {
      const goes = intent.goes.get(port) ?? "end";
      lead(id, port, goes === "next" ? next : undefined, goes === "leave" ? leaves : succeeds);
      operations.push(...markNext(tree, id, port, goes === "next" && next === undefined, newId));
    }
    const { failure, retry, ask } = intent;
    for (const { name: port } of errors) {
      if (failure.kind === "retry") lead(id, port, handler(retry), undefined);
      else fail(id, port, failure.kind);
    }
    if (retry !== undefined && failure.kind === "retry") {
      lead(retry, "again", name, undefined);
      fail(retry, "give_up", failure.then);
    }
    if (ask !== undefined) {
      lead(ask, "retry", name, undefined);
      lead(ask, "skip", next, succeeds);
      lead(ask, "abort", undefined, stops);
    }
  }
  const [first] = enabled;
  return [
    ...operations, ...beginsWith(tree, composite, first === undefined ? undefined : nameOfElement(tree, first.id)),
    ...becomes(tree, composite, "success", first === undefined ? ["True"] : succeeds, newId), ...becomes(tree, composite, "error", stops, newId),
    ...(loopOf(tree, composite) === undefined ? [] : leavesWhen(tree, composite, leaves, newId)),
  ];
}

const leavePort = (tree: Tree, body: string): string | undefined => listOf(tree, body, "ports").find((id) => nameOfElement(tree, id) === kLeaves);

/** The port with which what is repeated ends its loop is there only if a step does so. */
function leavesWhen(tree: Tree, body: string, terms: readonly string[], newId: NewId): readonly Operation[] {
  const port = leavePort(tree, body);
  if (terms.length > 0) return becomes(tree, body, kLeaves, terms, newId);
  return port === undefined ? [] : [...withoutCommentsOn(tree, [port]), { op: "remove", id: port }];
}

function beginsWith(tree: Tree, composite: string, first: Target): readonly Operation[] {
  const now = textOf(entryOf(elementOf(tree, composite).fields, "first"));
  return now === first ? [] : [{ op: "set", id: composite, field: "first", ...(first !== undefined && { value: first }) }];
}

/** What a loop says. */
export function settleLoop(tree: Tree, loop: string, body: string, count: string, newId: NewId): readonly Operation[] {
  const [bodyName, countName] = [nameOfElement(tree, body), nameOfElement(tree, count)];
  const ends = [conditionTerm(countName, "done"), ...(leavePort(tree, body) === undefined ? [] : [conditionTerm(bodyName, kLeaves)])];
  return [
    ...leadTo(tree, body, kLeaves, undefined, newId), ...leadTo(tree, body, "success", countName, newId), ...leadTo(tree, body, "error", undefined, newId),
    ...leadTo(tree, count, "again", bodyName, newId), ...leadTo(tree, count, "done", undefined, newId), ...beginsWith(tree, loop, bodyName),
    ...becomes(tree, loop, "success", ends, newId), ...becomes(tree, loop, "error", [conditionTerm(bodyName, "error")], newId),
  ];
}
