// The RSMs of all services as one set of states and one of operations, both as bits of a number: what calls may make of a set of states.
import type { Rsm, RsmTransition } from "../../generated/messages";
import type { Call } from "./calls";

/** A service by its key in `svc.key`; one that says nothing about its states is left out. */
export interface KnownService {
  readonly key: string;
  readonly rsm: Rsm;
}

/** States of services, or operations: one bit each. */
export type Bits = bigint;

export interface Operation {
  readonly key: string;
  readonly name: string;
  readonly bit: Bits;
  /** The states in which it is accepted. */
  readonly accepted: Bits;
  /** The states in which its service may be just after it answered a call with a result. */
  readonly answered: Bits;
}

interface Edge {
  readonly from: Bits;
  readonly to: Bits;
  /** None: spontaneous. */
  readonly operation: Bits;
}

export interface Automata {
  readonly operations: readonly Operation[];
  /** The states in which the services are when a run begins. */
  readonly initial: Bits;
  /** The operations that the services themselves may call. */
  readonly ownCalls: Bits;
  /** All states of a service. */
  readonly statesOf: (key: string) => Bits;
  readonly names: (states: Bits) => readonly string[];
  /** What the calls may be of; calls of services that are not known are left out. */
  readonly called: (calls: readonly Call[]) => Bits;
  /** `states`, and what one call may make of them: it may be refused, or lost. */
  readonly after: (states: Bits, operation: Bits) => Bits;
  /** `states`, and what any calls of `operations` and the services by themselves may make of them. */
  readonly closure: (states: Bits, operations: Bits) => Bits;
}

type Complete = KnownService & { readonly states: readonly string[]; readonly init: string; readonly transitions: readonly RsmTransition[] };

function complete({ key, rsm }: KnownService): readonly Complete[] {
  const { init, transitions = [], states = [] } = rsm;
  if (init === undefined) return [];
  const names = new Set([init, ...states.map(({ name }) => name), ...transitions.flatMap(({ src, dst }) => (src === undefined ? [dst] : [src, dst]))]);
  return [{ key, rsm, init, transitions, states: [...names] }];
}

/** The transitions with which a call that took `taken` may be answered with a result: resolve (4.2), without those that answer with an error. */
const answersOf = (taken: RsmTransition, all: readonly RsmTransition[]): readonly RsmTransition[] =>
  all.filter((t) => (t === taken ? (t.defer ?? []).length === 0 || t.src === undefined : t.error === undefined && (t.src === undefined || (taken.defer ?? []).includes(t.id))));

const union = (all: readonly Bits[]): Bits => all.reduce((sum, bits) => sum | bits, 0n);

/** All that is set in `next` is set in `bits`. */
export const contains = (bits: Bits, next: Bits): boolean => (bits | next) === bits;

export function automataOf(services: readonly KnownService[]): Automata {
  const known = services.flatMap(complete);
  const bits = new Map(known.flatMap(({ key, states }) => states.map((name) => `${key} ${name}`)).map((id, i) => [id, { bit: 1n << BigInt(i), name: id.slice(id.indexOf(" ") + 1) }]));
  const bitOf = (key: string, name: string): Bits => bits.get(`${key} ${name}`)?.bit ?? 0n;
  const all = new Map(known.map(({ key, states }) => [key, union(states.map((name) => bitOf(key, name)))]));
  const statesOf = (key: string): Bits => all.get(key) ?? 0n;
  const source = (key: string, { src }: RsmTransition): Bits => (src === undefined ? statesOf(key) : bitOf(key, src));

  const operations = known
    .flatMap(({ key, rsm, transitions }) => rsm.operations.map(({ name }) => ({ key, name, transitions })))
    .map(({ key, name, transitions }, i): Operation => {
      const taken = transitions.filter(({ operation }) => operation === name);
      const answers = taken.flatMap((t) => answersOf(t, transitions));
      return { key, name, bit: 1n << BigInt(i), accepted: union(taken.map((t) => source(key, t))), answered: union(answers.map(({ dst }) => bitOf(key, dst))) };
    });
  const called = (calls: readonly Call[]): Bits =>
    union(calls.flatMap(({ service, operation }) => operations.filter(({ key, name }) => name === operation && (service === undefined || key === service)).map(({ bit }) => bit)));
  const edges = known.flatMap(({ key, transitions }) =>
    transitions.map((t): Edge => ({ from: source(key, t), to: bitOf(key, t.dst), operation: t.operation === undefined ? 0n : called([{ service: key, operation: t.operation }]) })),
  );
  // A service names others by what they are.
  const ownCalls = union(known.flatMap(({ rsm }) => (rsm.calls ?? []).flatMap(({ service, operation }) => known.filter((each) => each.key === service || each.rsm.name === service).map(({ key }) => called([{ service: key, operation }])))));

  const step = (states: Bits, taken: readonly Edge[]): Bits => taken.reduce((sum, { from, to }) => ((states & from) === 0n ? sum : sum | to), states);
  const closures = new Map<Bits, { readonly edges: readonly Edge[]; readonly known: Map<Bits, Bits> }>();
  const closure = (states: Bits, mask: Bits): Bits => {
    const of = closures.get(mask) ?? { edges: edges.filter(({ operation }) => operation === 0n || (operation & mask) !== 0n), known: new Map<Bits, Bits>() };
    closures.set(mask, of);
    const before = of.known.get(states);
    if (before !== undefined) return before;
    let now = states;
    for (let next = step(now, of.edges); next !== now; next = step(now, of.edges)) now = next;
    of.known.set(states, now);
    return now;
  };
  return {
    operations,
    initial: union(known.map(({ key, init }) => bitOf(key, init))),
    ownCalls,
    statesOf,
    names: (states) => [...bits.values()].filter(({ bit }) => (states & bit) !== 0n).map(({ name }) => name),
    called,
    after: (states, operation) => step(states, edges.filter((edge) => (edge.operation & operation) !== 0n)),
    closure,
  };
}
