// All states of a task, with links followed: which calls each may make, and which others may be made while it is active.
import type { RcmDocument, State } from "../model/model";
import type { Automata, Bits } from "./automata";
import { behaviorOf, type Behavior } from "./behavior";
import { callsIn, type Call } from "./calls";
import { concurrently } from "./concurrency";

export interface Instance {
  readonly behavior: Behavior;
  readonly parent: Instance | undefined;
  /** Its child states by their names; of a draft, several may have the same one. */
  readonly children: ReadonlyMap<string, readonly Instance[]>;
  /** It may begin with any of its children: an oracle decides, or a history remembers. */
  readonly anyFirst: boolean;
  /** The calls of its actions and time-outs, which may be made at any time while it is active. */
  readonly acting: Bits;
  /** The calls of its children and of all in them. */
  readonly inner: Bits;
  /** The calls of others that may be made while it is active. */
  readonly others: Bits;
}

type Draft = { -readonly [K in keyof Instance]: Instance[K] };

/** With more states than this, nothing is said. */
const kMaxInstances = 20_000;

/** What the time-out of a port calls (core/SEMANTICS.md section 6). */
const kTimerCall: Call = { service: "timer", operation: "wait" };

interface Place {
  readonly parent: Instance | undefined;
  /** In a composite that remembers, with histories within, which child was active last. */
  readonly remembered: boolean;
  /** The library states that it is in. */
  readonly links: readonly string[];
}

/** The root and all in it, parents first; nothing if they are too many, or if a library state is within itself. */
export function instancesOf(document: RcmDocument, automata: Automata): readonly Instance[] | undefined {
  const found: Draft[] = [];
  const everything = automata.operations.reduce((sum, { bit }) => sum | bit, 0n);
  const called = (...codes: readonly string[]): Bits => automata.called(codes.flatMap(callsIn));
  /** All calls of an instance that is complete. */
  const totals = new Map<Instance, Bits>();
  const all = (instance: Instance): Bits => totals.get(instance) ?? 0n;

  const add = (state: State, { parent, remembered, links }: Place): Draft | undefined => {
    const behavior = behaviorOf(document, state);
    const taken = behavior.sources.slice(1).map(({ name }) => name);
    if (found.length >= kMaxInstances || taken.some((name) => links.includes(name))) return undefined;
    const free = behavior.unknown || behavior.oracle === "external";
    const timed = behavior.exits.some((exit) => exit.timed) ? automata.called([kTimerCall]) : 0n;
    const children = new Map<string, readonly Instance[]>();
    const acting = free ? everything : called(...behavior.actions) | timed;
    const made: Draft = { behavior, parent, children, anyFirst: remembered || behavior.oracle !== undefined, acting, inner: 0n, others: 0n };
    found.push(made);
    const inside = { parent: made, remembered: remembered || behavior.oracle === "history" || behavior.oracle === "deep history", links: [...links, ...taken] };
    for (const child of behavior.children) {
      if (child.kind === "barrier") continue;
      const inner = add(child, inside);
      if (inner === undefined) return undefined;
      children.set(child.name, [...(children.get(child.name) ?? []), inner]);
      made.inner |= all(inner);
    }
    totals.set(made, called(behavior.entry, behavior.exit) | acting | made.inner);
    return made;
  };
  if (add(document.root, { parent: undefined, remembered: false, links: [] }) === undefined) return undefined;

  const beside = new Map<Instance, Bits>();
  for (const made of found) {
    const around = made.parent === undefined ? automata.ownCalls : made.parent.others | made.parent.acting;
    made.others = around | (beside.get(made) ?? 0n);
    const calls = (name: string): Bits => (made.children.get(name) ?? []).reduce((sum, child) => sum | all(child), 0n);
    for (const [name, bits] of concurrently(made.behavior.children, calls)) for (const child of made.children.get(name) ?? []) beside.set(child, bits);
  }
  return found;
}
