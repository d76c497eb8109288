// Where ports and barriers of siblings lead, and which siblings may be active at the same time.
import type { Node } from "../model/model";
import type { Bits } from "./automata";

/** The states that a name of a sibling leads to: a state to itself, a barrier to all of its targets. */
export type Targets = ReadonlyMap<string, readonly string[]>;

const kNowhere: readonly string[] = [];

export const targetsOf = (children: readonly Node[]): Targets => new Map(children.map((child) => [child.name, child.kind === "state" ? [child.name] : child.to]));

/** The states that one of these names leads to. */
export const leading = (targets: Targets, name: string | undefined): readonly string[] => (name === undefined ? kNowhere : (targets.get(name) ?? kNowhere));

type Links = ReadonlyMap<string, readonly string[]>;

const link = (links: Map<string, string[]>, from: string, to: string): void => {
  const known = links.get(from);
  if (known === undefined) links.set(from, [to]);
  else known.push(to);
};

/** Lets the bits of each name pass to those that it leads to, and so on. */
function spread(bits: ReadonlyMap<string, Bits>, next: Links): ReadonlyMap<string, Bits> {
  const all = new Map(bits);
  const waiting = new Set(bits.keys());
  for (const name of waiting) {
    waiting.delete(name);
    const own = all.get(name) ?? 0n;
    for (const target of next.get(name) ?? kNowhere) {
      const before = all.get(target) ?? 0n;
      if ((before | own) === before) continue;
      all.set(target, before | own);
      waiting.add(target);
    }
  }
  return all;
}

/** For each of these, the bits of all others: those before it with those behind it. */
function othersOf(each: readonly Bits[]): readonly Bits[] {
  const behind: Bits[] = [];
  each.reduceRight((sum, bits, i) => ((behind[i] = sum), sum | bits), 0n);
  let before = 0n;
  return each.map((bits, i) => {
    const others = before | (behind[i] ?? 0n);
    before |= bits;
    return others;
  });
}

/**
 * For each state beside which others may be active: their calls; `calls`: those that are made in a state. Two states are active at a time
 * only if different targets of one barrier lead to them.
 */
export function concurrently(children: readonly Node[], calls: (name: string) => Bits): ReadonlyMap<string, Bits> {
  const forks = children.filter((child) => child.kind === "barrier" && child.to.length > 1);
  if (forks.length === 0) return new Map();
  const targets = targetsOf(children);
  const [next, previous] = [new Map<string, string[]>(), new Map<string, string[]>()];
  const states = children.filter((child) => child.kind === "state");
  for (const { name, ports } of states) {
    for (const target of ports.flatMap(({ to }) => leading(targets, to))) {
      link(next, name, target);
      link(previous, target, name);
    }
  }
  /** What is called in a state and in those that it leads to. */
  const onwards = spread(new Map(states.map(({ name }) => [name, calls(name)])), previous);
  const beside = new Map<string, Bits>();
  for (const { name } of forks) {
    const branches = leading(targets, name);
    othersOf(branches.map((target) => onwards.get(target) ?? 0n)).forEach((others, i) => {
      const target = branches[i] ?? "";
      beside.set(target, (beside.get(target) ?? 0n) | others);
    });
  }
  return spread(beside, next);
}
