// In which states the services may be at each place of a task: the least sets that hold for every run (a fixpoint).
// A call never takes a state out of a set, since it may be refused or lost; only what a port has seen (calls.ts, facts) does.
import { contains, type Automata, type Bits } from "./automata";
import { callsIn, factsOf, repeats, type Fact } from "./calls";
import { leading, targetsOf, type Targets } from "./concurrency";
import type { Instance } from "./instances";

/** At the places of a state: sets of states of services. */
export interface Reach {
  /** Before its entry. */
  readonly entered: Bits;
  /** While it is active, its children too: where its actions are executed, and before its exit. */
  readonly active: Bits;
}

interface Known extends Reach {
  /** Anywhere in it. */
  readonly any: Bits;
  /** When it has been left, by port. */
  readonly left: ReadonlyMap<string, Bits>;
}

const kNever: Known = { entered: 0n, active: 0n, any: 0n, left: new Map() };

/** `states` after code was executed in which others call `others` meanwhile. */
export function afterCode(automata: Automata, states: Bits, code: string, others: Bits): Bits {
  const calls = callsIn(code);
  if (repeats(code)) return automata.closure(states, others | automata.called(calls));
  return calls.reduce((now, call) => automata.closure(automata.after(now, automata.called([call])), others), automata.closure(states, others));
}

/** The calls in `code` that may be made after the first one of this operation. */
function callsAfter(automata: Automata, code: string, operation: Bits): Bits {
  const calls = callsIn(code);
  const first = repeats(code) ? -1 : calls.findIndex((call) => (automata.called([call]) & operation) !== 0n);
  return first < 0 && !repeats(code) ? 0n : automata.called(calls.slice(first + 1));
}

export function reachOf(automata: Automata, instances: readonly Instance[]): ReadonlyMap<Instance, Reach> {
  const known = new Map<Instance, Known>();
  const knownOf = (instance: Instance): Known => known.get(instance) ?? kNever;
  const targets = new Map<Instance, Targets>(instances.map((instance) => [instance, targetsOf(instance.behavior.children)]));
  const waiting = new Set<Instance>();

  const enter = (instances: readonly Instance[], states: Bits): void => {
    for (const instance of instances) {
      const before = knownOf(instance);
      const now = automata.closure(before.entered | states, instance.others);
      if (now === before.entered && known.has(instance)) continue;
      known.set(instance, { ...before, entered: now });
      waiting.add(instance);
    }
  };

  /** What a fact leaves of the states in which a port of the instance may be tested. */
  const narrowed = (instance: Instance, states: Bits, fact: Fact): Bits => {
    const { behavior, acting, inner, others, children } = instance;
    if (fact.type === "left") {
      const [child, second] = children.get(fact.child) ?? [];
      const exit = child?.behavior.exits.find(({ name }) => name === fact.port);
      if (child === undefined || second !== undefined || exit === undefined || exit.to !== undefined) return states;
      return states & automata.closure(knownOf(child).left.get(fact.port) ?? 0n, child.others);
    }
    const operation = automata.operations.find(({ key, name }) => key === fact.service && name === fact.operation);
    const within = automata.called(callsIn(behavior.entry)) | acting | inner;
    // Else it is the response to a call of somebody else.
    if (operation === undefined || (within & operation.bit) === 0n) return states;
    const service = automata.statesOf(operation.key);
    const later = acting | inner | others | callsAfter(automata, behavior.entry, operation.bit);
    return states & (~service | automata.closure(operation.answered, later));
  };

  const follow = (instance: Instance): void => {
    const { behavior, parent, others, acting, children } = instance;
    const before = knownOf(instance);
    const begun = automata.closure(afterCode(automata, before.entered, behavior.entry, others), others | acting);
    const leads = targets.get(instance) ?? new Map<string, readonly string[]>();
    for (const name of instance.anyFirst ? children.keys() : leading(leads, behavior.first)) enter(children.get(name) ?? [], begun);
    const inside = [...children.values()].flat().reduce((sum, child) => sum | knownOf(child).any, begun);
    const active = automata.closure(inside, others | acting);
    const left = new Map<string, Bits>();
    for (const exit of behavior.exits) {
      const tested = factsOf(exit.when).reduce((states, fact) => narrowed(instance, states, fact), active);
      const states = (left.get(exit.name) ?? 0n) | afterCode(automata, tested, behavior.exit, others);
      left.set(exit.name, states);
      if (parent === undefined) continue;
      for (const name of leading(targets.get(parent) ?? leads, exit.to)) enter(parent.children.get(name) ?? [], states);
    }
    const any = active | before.entered | afterCode(automata, active, behavior.exit, others);
    const { entered } = knownOf(instance);
    known.set(instance, { entered, active, any, left });
    if (parent === undefined) return;
    // A port that leads on says nothing to the parent.
    const grew = behavior.exits.some(({ name, to }) => to === undefined && !contains(before.left.get(name) ?? 0n, left.get(name) ?? 0n));
    if (grew || !contains(knownOf(parent).active, any)) waiting.add(parent);
  };

  enter(instances.slice(0, 1), automata.initial);
  for (const instance of waiting) {
    waiting.delete(instance);
    follow(instance);
  }
  return known;
}
