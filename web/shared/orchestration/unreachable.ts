// Assistance in orchestration (thesis ch. 4): the operations that no service can accept at a place of the model, and why.
import { keyOf, type RcmDocument, type State } from "../model/model";
import { automataOf, type Automata, type Bits, type KnownService } from "./automata";
import { instancesOf, type Instance } from "./instances";
import { afterCode, reachOf, type Reach } from "./reach";

/** Code of a state. `before`: its text in front of the place where something is inserted; without: all of it. */
export type CodePlace = { readonly code: "entry" | "exit"; readonly before?: string } | { readonly code: "action" };

interface Analysis {
  readonly services: readonly KnownService[];
  readonly automata: Automata;
  /** By the state that it is written in, one for each link that leads there. */
  readonly instances: ReadonlyMap<State, readonly Instance[]>;
  readonly reach: ReadonlyMap<Instance, Reach>;
}

const analyses = new WeakMap<RcmDocument, Analysis>();

const same = (a: readonly KnownService[], b: readonly KnownService[]): boolean => a.length === b.length && a.every(({ key, rsm }, i) => b[i]?.key === key && b[i].rsm === rsm);

/** Made once for a document and the RSMs of its services. */
function analysisOf(document: RcmDocument, services: readonly KnownService[]): Analysis {
  const before = analyses.get(document);
  if (before !== undefined && same(before.services, services)) return before;
  const automata = automataOf(services);
  const all = instancesOf(document, automata) ?? [];
  const instances = new Map<State, Instance[]>();
  for (const instance of all) {
    for (const state of instance.behavior.sources) {
      const list = instances.get(state);
      if (list === undefined) instances.set(state, [instance]);
      else list.push(instance);
    }
  }
  const made = { services: services.map(({ key, rsm }) => ({ key, rsm })), automata, instances, reach: reachOf(automata, all) };
  analyses.set(document, made);
  return made;
}

/** The states with this path: below the root, or below a library state. */
function statesAt({ root, library }: RcmDocument, path: string): readonly State[] {
  const [first, ...rest] = path.split("/");
  return [root, ...library]
    .filter((top) => keyOf(top) === first || top.name === first)
    .flatMap((top) => {
      const found = rest.reduce<State | undefined>((state, key) => state?.children.find((child): child is State => child.kind === "state" && keyOf(child) === key), top);
      return found === undefined ? [] : [found];
    });
}

/** In which states services may be where this code runs. */
function statesIn(automata: Automata, { behavior, others }: Instance, { entered, active }: Reach, place: CodePlace): Bits {
  if (place.code === "action") return active;
  return afterCode(automata, place.code === "entry" ? entered : active, place.before ?? behavior[place.code], others);
}

const list = (names: readonly string[]): string => names.map((name) => `\`${name}\``).join(" or ");

/**
 * The operations, as `svc.key.operation`, that are accepted in none of the states in which their service may be there, with the reason.
 * What is not known for sure is not in it: see README.md, which says what is assumed.
 */
export function unreachableOperations(document: RcmDocument, services: readonly KnownService[], path: string, place: CodePlace): ReadonlyMap<string, string> {
  const { automata, instances, reach } = analysisOf(document, services);
  const here = statesAt(document, path).flatMap((state) => instances.get(state) ?? []);
  const states = here.reduce((sum, instance) => sum | statesIn(automata, instance, reach.get(instance) ?? { entered: 0n, active: 0n }, place), 0n);
  const found = new Map<string, string>();
  for (const { key, name, accepted } of automata.operations) {
    const possible = states & automata.statesOf(key);
    if (possible === 0n || (possible & accepted) !== 0n) continue;
    const when = accepted === 0n ? "in no state" : `in ${list(automata.names(accepted))}`;
    found.set(`svc.${key}.${name}`, `${key} can only be in ${list(automata.names(possible))} here; ${name} is accepted ${when}`);
  }
  return found;
}
