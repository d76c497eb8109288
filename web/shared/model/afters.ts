// Time-outs of ports (`after`; core/SEMANTICS.md, section 6) in a translated model: the states that wait and the barrier that
// enters them become parts of the ports again, so that the pages show the ports as their author wrote them.
import type { Node, Port, State } from "./model";
import { portAt, splitAddress, stateAt, type ModelTree } from "./modelTree";
import type { Origin } from "./oracles";

const kBarrier = "After";
const waitingName = (port: string): string => `${kBarrier}_${port}`;

/** The path in the native model of the state that waits for this port. */
export function waitingState(address: string): string {
  const { path, port } = splitAddress(address) ?? { path: address, port: "" };
  return `${path}/${waitingName(port)}`;
}

/** What translation made of the time-out of a port. */
interface Made {
  readonly port: Port;
  readonly name: string;
  readonly seconds: string;
  /** The path in the document of the state that has the port. */
  readonly home: string;
}

/** A child that was made comes from a port; one that was written, from a node. */
function madeOf(state: State, path: string, origin: Origin): readonly Made[] {
  return state.ports.flatMap((port) => {
    const name = waitingName(port.name);
    const from = splitAddress(origin[`${path}/${name}`] ?? "");
    const child = state.children.find((each) => each.name === name);
    const seconds = child?.kind === "state" ? child.parameters.find((parameter) => parameter.name === "seconds")?.from : undefined;
    return from?.port === port.name && seconds !== undefined ? [{ port, name, seconds, home: from.path }] : [];
  });
}

/** The `first` of a state whose activation leads to these children: the barrier that leads to them, if there was one. */
function writtenFirst(targets: readonly string[], children: readonly Node[]): string | undefined {
  const same = children.filter((child) => child.kind === "barrier" && child.to.join() === targets.join());
  const led = new Set(children.flatMap((child) => (child.kind === "state" ? child.ports.map(({ to }) => to) : [])));
  // A barrier to which no port leads is entered as `first`, or never.
  const entered = same.find(({ name }) => !led.has(name))?.name;
  return entered ?? (targets.length > 1 ? same[0]?.name : targets[0]);
}

/** The state without what was made of the time-outs of its ports. */
function fold(state: State, path: string, origin: Origin): State {
  const made = madeOf(state, path, origin);
  if (made.length === 0) return state;
  const names = new Set(made.map(({ name }) => name));
  const ports = state.ports.map((port): Port => {
    const seconds = made.find((each) => each.port === port)?.seconds;
    if (seconds === undefined) return port;
    const { when, ...rest } = port;
    return { ...rest, after: seconds };
  });
  const barrier = state.children.find((child) => child.name === kBarrier && origin[`${path}/${kBarrier}`] === made[0]?.home);
  const children = state.children.filter((child) => child !== barrier && !names.has(child.name));
  const { first: translated, ...rest } = state;
  if (barrier?.kind !== "barrier") return { ...rest, ports, children };
  const first = writtenFirst(barrier.to.filter((name) => !names.has(name)), children);
  return { ...rest, ports, children, ...(first !== undefined && { first }) };
}

/** The model with its time-outs as `after` of ports, in place of what they were translated to. */
export function withAfters(root: State, origin: Origin): State {
  const visit = (state: State, path: string): State => {
    const children = state.children.map((child): Node => (child.kind === "barrier" ? child : visit(child, `${path}/${child.name}`)));
    return fold({ ...state, children }, path, origin);
  };
  return visit(root, root.name);
}

const kMade = /^(.+)\/After(?:_(\w+)(?:\.due)?)?$/;

/** The port or state of `tree` of which the node or port at this address of the native model was made; undefined: of none. */
export function timedElement(tree: ModelTree, address: string): string | undefined {
  const [, path, port] = kMade.exec(address) ?? [];
  if (path === undefined) return undefined;
  if (port === undefined) return stateAt(tree, path)?.ports.some(({ after }) => after !== undefined) === true ? path : undefined;
  return portAt(tree, `${path}.${port}`)?.after === undefined ? undefined : `${path}.${port}`;
}
