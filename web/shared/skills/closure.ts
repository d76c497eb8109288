// What a library state needs: the library states that it links, and theirs; and the services that their code names.
import { elementOf, subtree, type Tree } from "../edit/tree";
import { entryOf, isObject } from "../json";
import { referencesIn } from "../code/references";
import { linkedState } from "./declared";

/** The library state `id` and all that it links, what is linked before what links it. */
export function closureOf(tree: Tree, id: string): readonly string[] {
  const found: string[] = [];
  const open = new Set<string>();
  const visit = (state: string): void => {
    if (open.has(state)) return;
    open.add(state);
    for (const inner of subtree(tree, state)) {
      const linked = elementOf(tree, inner).kind === "state" ? linkedState(tree, inner) : undefined;
      if (linked !== undefined) visit(linked);
    }
    found.push(state);
  };
  visit(id);
  return found;
}

const kCode = ["entry", "exit", "when", "do", "after", "from"] as const;

/** The keys of services that the code of a state names, with those of what it links, by name. A time-out of a port needs the timer. */
export function servicesOf(tree: Tree, id: string): readonly string[] {
  const keys = new Set<string>();
  const read = (code: unknown): void => {
    if (typeof code === "string") for (const { names } of referencesIn(code)) if (names[0] === "svc" && names[1] !== undefined) keys.add(names[1]);
  };
  for (const state of closureOf(tree, id))
    for (const inner of subtree(tree, state)) {
      const { fields } = elementOf(tree, inner);
      for (const field of kCode) read(entryOf(fields, field));
      const oracle = entryOf(fields, "oracle");
      if (isObject(oracle)) [oracle["expr"], oracle["call"]].forEach(read);
      if (entryOf(fields, "after") !== undefined) keys.add("timer");
    }
  return [...keys].sort();
}

/** A service that the server has. */
export interface ServiceHere {
  readonly key: string;
  readonly type: string;
  readonly available: boolean;
}

export const declaredServices = (tree: Tree): Readonly<Record<string, string>> => {
  const services = entryOf(tree.fields, "services");
  return isObject(services) ? Object.fromEntries(Object.entries(services).filter((entry): entry is [string, string] => typeof entry[1] === "string")) : {};
};

/** The services that a state needs and the server does not have now, in words. */
export function missingServices(tree: Tree, id: string, here: readonly ServiceHere[]): readonly string[] {
  const types = declaredServices(tree);
  return servicesOf(tree, id).filter((key) => !here.some((service) => service.available && (service.key === key || service.type === types[key])));
}

/** The key of a service, for people. */
const kServices: Readonly<Record<string, string>> = {
  robot: "the robot", gripper: "the gripper", db: "the database", obj_rec: "the recognition of objects", camera: "the camera", display: "a display", audio: "the sounds", timer: "the timer",
};
export const serviceText = (key: string): string => kServices[key] ?? `the service ${key}`;

