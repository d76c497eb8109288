// Small tasks and services for the tests of assistance in orchestration.
import type { Rsm, RsmTransition } from "../../generated/messages";
import type { KnownService } from "../../shared/orchestration/automata";
import type { Barrier, Node, Port, RcmDocument, State } from "../../shared/model/model";

export const state = (name: string, fields: Partial<Omit<State, "kind" | "name">> = {}): State => ({
  kind: "state", name, parameters: [], results: [], variables: [], actions: [], children: [], ports: [], ...fields,
});

/** `name: condition -> target` */
export function port(text: string): Port {
  const [, name = "", when = "", to] = /^(\w+): (.*?)(?: -> (\w+))?$/.exec(text) ?? [];
  return { name, when, ...(to !== undefined && { to }) };
}

export const barrier = (name: string, ...to: readonly string[]): Barrier => ({ kind: "barrier", name, to });

/** A composite that begins with its first child. */
export const composite = (name: string, children: readonly Node[], fields: Partial<Omit<State, "kind" | "name">> = {}): State => {
  const [first] = children;
  return state(name, { children, ...(first !== undefined && { first: first.name }), ...fields });
};

export const action = (when: string, code: string) => ({ when, do: code });

export const task = (root: State, ...library: readonly State[]): RcmDocument => ({ name: "task", services: {}, library, root });

/** `id: source operation -> destination`; `any` for every source, `-` for no operation. */
export function transition(text: string, more: Partial<RsmTransition> = {}): RsmTransition {
  const [, id = "", src = "", operation = "", dst = ""] = /^(\w+): (\w+) (\S+) -> (\w+)$/.exec(text) ?? [];
  return { id, dst, ...(src !== "any" && { src }), ...(operation !== "-" && { operation }), ...more };
}

export function service(key: string, init: string, transitions: readonly RsmTransition[]): KnownService {
  const names = new Set(transitions.flatMap(({ operation }) => (operation === undefined ? [] : [operation])));
  const states = new Set([init, ...transitions.flatMap(({ src, dst }) => (src === undefined ? [dst] : [src, dst]))]);
  const rsm: Rsm = { rsm: 1, name: key, operations: [...names].map((name) => ({ name })), events: [], states: [...states].map((name) => ({ name })), init, transitions };
  return { key, rsm };
}

/** A lamp that is off until somebody switches it on. */
export const kLamp = service("lamp", "off", [transition("t1: off light -> on"), transition("t2: on dim -> on"), transition("t3: on douse -> off")]);

/** An arm that moves until it is there. */
export const kArm = service("arm", "idle", [
  transition("move: idle move -> moving", { defer: ["done"] }), transition("done: moving - -> idle"), transition("halt: moving halt -> idle", { error: "stopped" }), transition("grasp: idle grasp -> idle"),
]);
