// The state of a run in the addresses of the model that is edited: its elements are found by their ids, wherever an edit has put them and whatever
// it has called them. What the edited model does not have is left out.
import { kNoRun, type Live } from "../drawing/live";
import { timedElement, waitingState } from "../model/afters";
import { selectionsOf } from "../model/identity";
import { portAddress, type Identified, type State } from "../model/model";
import { stateAt, type ModelTree } from "../model/modelTree";
import type { ValueTable } from "../run/liveState";
import { Table } from "../run/table";

type Names = ReadonlyMap<string, string>;

/** Where a model has the elements of another one. */
interface Places {
  readonly onto: ModelTree;
  /** By path, and by address of a port. */
  readonly addresses: Names;
  /** For states by their paths: the names of parameters, results and variables, if one of them has another one. */
  readonly names: ReadonlyMap<string, Readonly<Record<Scope, Names>>>;
}

type Scope = "parameters" | "results" | "variables";

/** The names in `onto` of what is in the list `of`; nothing if all have the same. */
function renamed(of: readonly (Identified & { readonly name: string })[], onto: readonly (Identified & { readonly name: string })[]): Names {
  const now = new Map(onto.map(({ id, name }) => [id, name]));
  return new Map(of.flatMap(({ id, name }) => (id === undefined || !now.has(id) ? [] : [[name, now.get(id) ?? name] as const])));
}

const hasOther = (names: Names): boolean => [...names].some(([was, is]) => was !== is);

function namesOf(of: State, onto: State): Readonly<Record<Scope, Names>> | undefined {
  const all = { parameters: renamed(of.parameters, onto.parameters), results: renamed(of.results, onto.results), variables: renamed(of.variables, onto.variables) };
  return Object.values(all).some(hasOther) ? all : undefined;
}

function findPlaces(of: ModelTree, onto: ModelTree): Places {
  const [addresses, names] = [new Map<string, string>(), new Map<string, Readonly<Record<Scope, Names>>>()];
  const found = selectionsOf(onto);
  for (const { path, node } of of.values()) {
    const at = node.id === undefined ? undefined : found.get(node.id);
    if (at?.kind !== "node") continue;
    addresses.set(path, at.path);
    const now = stateAt(onto, at.path);
    if (node.kind !== "state" || now === undefined) continue;
    for (const port of node.ports) {
      const to = port.id === undefined ? undefined : found.get(port.id);
      if (to?.kind === "port") addresses.set(portAddress(path, port), to.address);
    }
    const others = namesOf(node, now);
    if (others !== undefined) names.set(path, others);
  }
  return { onto, addresses, names };
}

/** For each model of a run, the last one that it was projected onto. */
const known = new WeakMap<ModelTree, Places>();

function placesOf(of: ModelTree, onto: ModelTree): Places {
  const before = known.get(of);
  if (before?.onto === onto) return before;
  const found = findPlaces(of, onto);
  known.set(of, found);
  return found;
}

function valuesIn({ addresses, names }: Places, scope: Scope, all: ValueTable): ValueTable {
  return Table.of(
    [...all.entries()].flatMap(([path, values]) => {
      const at = addresses.get(path);
      const others = names.get(path)?.[scope];
      if (at === undefined) return [];
      return [[at, others === undefined ? values : Object.fromEntries(Object.entries(values).map(([name, value]) => [others.get(name) ?? name, value]))] as const];
    }),
  );
}

/** `of`: the model of the run, whose addresses are in `live`; `onto`: the one that is drawn. */
export function projectLive(live: Live, of: ModelTree, onto: ModelTree): Live {
  const { run } = live;
  if (run === undefined) return kNoRun;
  const places = placesOf(of, onto);
  /** A state that waits for the time-out of a port is part of that port. */
  const at = (address: string): string | undefined => {
    const found = places.addresses.get(address);
    if (found !== undefined) return found;
    const port = of.has(address) ? undefined : timedElement(of, address);
    const timed = port === undefined || port === address || of.has(port) ? undefined : places.addresses.get(port);
    return timed && waitingState(timed);
  };
  const all = (addresses: Iterable<string>): readonly string[] => [...addresses].flatMap((address) => at(address) ?? []);
  const [active, ports, fired] = [all(live.active), all(live.ports), all(live.fired)];
  const activated = Object.fromEntries(Object.entries(live.activated).flatMap(([path, arrived]) => (at(path) === undefined ? [] : [[at(path) ?? path, all(arrived)] as const])));
  return {
    active: new Set(active), ports: new Set(ports), fired: new Set(fired), fireCount: live.fireCount, activated,
    run: {
      active, ports, activated: Object.fromEntries(Object.entries(activated).map(([path, arrived]) => [path, [...arrived]])),
      parameters: valuesIn(places, "parameters", run.parameters), results: valuesIn(places, "results", run.results), variables: valuesIn(places, "variables", run.variables),
    },
    faultAt: live.faultAt === undefined ? undefined : at(live.faultAt),
    badEnd: live.badEnd === undefined ? undefined : at(live.badEnd),
  };
}
