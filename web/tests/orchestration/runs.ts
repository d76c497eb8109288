// All runs of a small task by brute force: every order of micro steps, transitions of services, answers and lost calls.
// It is another reading of core/SEMANTICS.md than that of web/shared/orchestration, without sets: one situation after the other.
import type { RsmTransition } from "../../generated/messages";
import type { KnownService } from "../../shared/orchestration/automata";
import type { Node, RcmDocument, State } from "../../shared/model/model";

interface Situation {
  /** Of each service. */
  current: Record<string, string>;
  /** Of active states and barriers, and active ports. */
  active: string[];
  /** Of barriers: the ports that have arrived. */
  arrived: Record<string, string[]>;
  /** Of active states: the caller of the latest call in them, by operation. */
  latest: Record<string, Record<string, string>>;
  /** Calls that wait for the transition that answers, by the one that they took. */
  pending: Record<string, string[]>;
  /** Calls that were answered with a result. */
  answered: string[];
}

/** A place of the task, and a state in which a service was while its code was executed. */
export type Seen = (path: string, code: "entry" | "exit" | "action", service: string, current: string) => void;

/** More than these situations are not looked at. */
const kMaxSituations = 700;

const calls = (code: string): readonly { readonly service: string; readonly operation: string }[] =>
  [...code.matchAll(/svc\.(\w+)\.(\w+)\(\)/g)].map(([, service = "", operation = ""]) => ({ service, operation }));
const below = (path: string, inner: string): boolean => inner === path || inner.startsWith(`${path}/`);
const copy = (situation: Situation): Situation => structuredClone(situation);

export function everyRun({ root }: RcmDocument, services: readonly KnownService[], seen: Seen): void {
  const nodes = new Map<string, Node>();
  const index = (node: Node, path: string): void => {
    nodes.set(path, node);
    if (node.kind === "state") for (const child of node.children) index(child, `${path}/${child.name}`);
  };
  index(root, root.name);
  const stateAt = (path: string): State | undefined => {
    const node = nodes.get(path);
    return node?.kind === "state" ? node : undefined;
  };
  const transitionsOf = (key: string): readonly RsmTransition[] => services.find((service) => service.key === key)?.rsm.transitions ?? [];

  /** What a transition answers (4.2). */
  const answer = (now: Situation, key: string, t: RsmTransition): void => {
    for (const x of transitionsOf(key)) {
      if (!(t.src === undefined || (x.id === t.id && (t.defer ?? []).length === 0) || (x.defer ?? []).includes(t.id))) continue;
      const waiting = now.pending[`${key} ${x.id}`] ?? [];
      now.pending[`${key} ${x.id}`] = [];
      if (t.error === undefined || x.id === t.id) now.answered.push(...waiting);
    }
  };
  const take = (now: Situation, key: string, t: RsmTransition): Situation => {
    const next = copy(now);
    next.current[key] = t.dst;
    answer(next, key, t);
    return next;
  };
  const possible = (now: Situation, key: string, operation: string | undefined) => transitionsOf(key).filter((t) => t.operation === operation && (t.src === undefined || t.src === now.current[key]));
  const alone = (now: Situation): readonly Situation[] => services.flatMap(({ key }) => possible(now, key, undefined).map((t) => take(now, key, t)));

  /** Lost, refused, or accepted. */
  const call = (now: Situation, path: string, { service, operation }: { readonly service: string; readonly operation: string }): readonly Situation[] => {
    const id = `${path} ${service}.${operation}`;
    const made = copy(now);
    made.answered = made.answered.filter((each) => each !== id);
    for (const waiting of Object.keys(made.pending)) made.pending[waiting] = (made.pending[waiting] ?? []).filter((each) => each !== id);
    for (const [state, latest] of Object.entries(made.latest)) if (below(state, path)) latest[`${service}.${operation}`] = id;
    return [made, ...possible(now, service, operation).slice(0, 1).map((t) => {
      const taken = copy(made);
      taken.pending[`${service} ${t.id}`] = [id];
      return take(taken, service, t);
    })];
  };
  const execute = (now: Situation, path: string, code: "entry" | "exit" | "action", text: string): readonly Situation[] => {
    const see = (situation: Situation) => Object.entries(situation.current).forEach(([key, current]) => seen(path, code, key, current));
    let all: readonly Situation[] = [now];
    see(now);
    for (const each of calls(text)) {
      // Between two calls a service may move.
      all = all.flatMap((situation) => [situation, ...alone(situation)]).flatMap((situation) => call(situation, path, each));
      all.forEach(see);
    }
    return all;
  };
  const without = (now: Situation, gone: (id: string) => boolean): Situation => ({ ...copy(now), active: now.active.filter((id) => !gone(id)) });
  const isPort = (path: string) => (id: string) => id.startsWith(`${path}.`);

  const enter = (now: Situation, path: string): readonly Situation[] => {
    const state = stateAt(path);
    if (state === undefined) return enterBarrier(now, path, undefined);
    if (now.active.includes(path)) return [now];
    const next = without(now, isPort(path));
    next.active.push(path);
    next.latest[path] = {};
    for (const [name, ports] of Object.entries(next.arrived)) next.arrived[name] = ports.filter((id) => !isPort(path)(id));
    return execute(next, path, "entry", state.entry ?? "").flatMap((entered) => (state.first === undefined ? [entered] : enter(entered, `${path}/${state.first}`)));
  };
  const enterBarrier = (now: Situation, path: string, arriving: string | undefined): readonly Situation[] => {
    const next = copy(now);
    const arrived = [...new Set([...(next.arrived[path] ?? []), ...(arriving === undefined ? [] : [arriving])])];
    next.arrived[path] = arrived;
    const parent = path.slice(0, path.lastIndexOf("/"));
    const inbound = (stateAt(parent)?.children ?? []).flatMap((child) => (child.kind === "state" ? child.ports.filter(({ to }) => `${parent}/${to ?? ""}` === path).map(({ name }) => `${parent}/${child.name}.${name}`) : []));
    if ((arriving === undefined || inbound.every((id) => arrived.includes(id))) && !next.active.includes(path)) next.active.push(path);
    return [next];
  };
  const leave = (now: Situation, path: string): readonly Situation[] => {
    const node = nodes.get(path);
    if (node?.kind !== "state") return [{ ...without(now, (id) => id === path), arrived: { ...now.arrived, [path]: [] } }];
    if (!now.active.includes(path)) return [without(now, isPort(path))];
    let all: readonly Situation[] = [now];
    for (const child of node.children) all = all.flatMap((each) => leave(each, `${path}/${child.name}`));
    return all.flatMap((each) => execute(each, path, "exit", node.exit ?? "")).map((each) => {
      const left = without(each, (id) => id === path);
      return { ...left, latest: Object.fromEntries(Object.entries(left.latest).filter(([state]) => state !== path)) };
    });
  };

  const fulfilled = (now: Situation, path: string, when: string): boolean => {
    const [, child, port] = /^chi\.(\w+)\.port\.(\w+)$/.exec(when) ?? [];
    if (child !== undefined && port !== undefined) return now.active.includes(`${path}/${child}.${port}`);
    const [, operation = ""] = /^svc\.(\w+\.\w+)\.result$/.exec(when) ?? [];
    const id = now.latest[path]?.[operation];
    return operation === "" || (id !== undefined && now.answered.includes(id));
  };
  /** One step of one state: of a port, of its children, or of an action. */
  const steps = (now: Situation, path: string): readonly Situation[] => {
    const state = stateAt(path);
    if (state === undefined) return [];
    const fired = state.ports.filter(({ when }) => fulfilled(now, path, when ?? "")).flatMap((p) => leave(now, path).map((left) => ({ ...left, active: [...left.active, `${path}.${p.name}`] })));
    const acted = state.actions.flatMap((each) => execute(now, path, "action", each.do));
    const moved = state.children.flatMap((child): readonly Situation[] => {
      const inner = `${path}/${child.name}`;
      if (child.kind === "barrier") {
        if (!now.active.includes(inner)) return [];
        return child.to.reduce<readonly Situation[]>((all, to) => all.flatMap((each) => enter(each, `${path}/${to}`)), leave(now, inner));
      }
      return child.ports.filter(({ name, to }) => to !== undefined && now.active.includes(`${inner}.${name}`)).flatMap(({ name, to = "" }) => {
        const passed = without(now, (id) => id === `${inner}.${name}`);
        return nodes.get(`${path}/${to}`)?.kind === "barrier" ? enterBarrier(passed, `${path}/${to}`, `${inner}.${name}`) : enter(passed, `${path}/${to}`);
      });
    });
    return [...fired, ...acted, ...moved];
  };

  const none: Situation = { current: Object.fromEntries(services.map(({ key, rsm }) => [key, rsm.init ?? ""])), active: [], arrived: {}, latest: {}, pending: {}, answered: [] };
  const known = new Set<string>();
  const waiting: Situation[] = [];
  const add = (all: readonly Situation[]): void => {
    for (const each of all) {
      const id = JSON.stringify({ ...each, active: [...each.active].sort(), answered: [...new Set(each.answered)].sort() });
      if (known.has(id) || known.size >= kMaxSituations) continue;
      known.add(id);
      waiting.push(each);
    }
  };
  add([none, ...alone(none)].flatMap((now) => enter(now, root.name)));
  for (let now = waiting.shift(); now !== undefined; now = waiting.shift()) {
    add(alone(now));
    for (const path of now.active) add(steps(now, path));
  }
}
