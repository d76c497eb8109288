// The scope of the condition of a breakpoint in the model that a run executes, whose document may not be here (scope.ts has that of a document).
import type { Declaration, Node, Parameter, State } from "../model/model";
import { valueName, type Name, type NameKind } from "./names";
import { referencesIn } from "./references";
import { languageNames, type Scope } from "./scope";
import { namesOfServices, type KnownService } from "./services";
import { kCollections, type Collection } from "./words";

const declared = (values: readonly (Parameter | Declaration)[], kind: NameKind): readonly Name[] =>
  values.map((value) => valueName(value.name, kind, "unit" in value || "doc" in value ? { unit: value.unit, doc: value.doc } : {}));

const portNames = ({ ports }: State): readonly Name[] => ports.map(({ name }) => ({ name, kind: "port", type: "bool", doc: "Whether it is active." }));

function childName(child: Node): Name {
  const own: readonly Name[] = [
    { name: "active", kind: "active", type: "bool", doc: "Whether the child is active." },
    { name: "name", kind: "constant", type: "string", doc: "The name of the child." },
  ];
  const { name } = child;
  if (child.kind === "barrier") return { name, kind: "child", members: () => own };
  const part = (of: Collection, members: () => readonly Name[]): Name => ({ name: of, kind: "collection", doc: kCollections[of], members });
  const members = () => [part("par", () => declared(child.parameters, "parameter")), part("res", () => declared(child.results, "result")), part("port", () => portNames(child)), ...own];
  return { name, kind: "child", members };
}

/** Children that the translation has made, which the pages show as parts of ports and states (model/afters.ts, model/oracles.ts). */
function madeChildren({ ports }: State): readonly Name[] {
  const timed = ports.filter(({ after }) => after !== undefined).map(({ name }) => `After_${name}`);
  return [...timed, ...(timed.length > 0 ? ["After"] : []), "Dispatcher"].map((name) => ({ name, kind: "child", isOpen: true }));
}

const textsOf = ({ entry, exit, actions, ports, children }: State): readonly (string | undefined)[] => [
  entry, exit, ...actions.flatMap((action) => [action.when, action.do]), ...ports.flatMap(({ when, after }) => [when, after]),
  ...children.flatMap((child) => (child.kind === "state" ? child.parameters.map(({ from }) => from) : [])),
];

/** Variables need no declaration: those that the texts of the state use are known, too. */
function variableNames(state: State): readonly Name[] {
  const known = declared(state.variables, "variable");
  const used = textsOf(state).flatMap((text) => referencesIn(text ?? "").flatMap(({ names: [root, name] }) => (root === "var" && name !== undefined ? [name] : [])));
  const others = [...new Set(used)].filter((name) => !known.some((each) => each.name === name));
  return [...known, ...others.map((name): Name => ({ name, kind: "variable", isOpen: true }))];
}

/** `services`: what the model declares, types by keys; `known`: what the server has. */
export function runScope(state: State, services: Readonly<Record<string, string>>, known: readonly KnownService[]): Scope {
  const collection = (name: Collection, members: () => readonly Name[], isOpen = false): Name => ({ name, kind: "collection", doc: kCollections[name], members, ...(isOpen && { isOpen: true }) });
  const own = [
    collection("par", () => declared(state.parameters, "parameter")),
    collection("res", () => declared(state.results, "result")),
    collection("var", () => variableNames(state), true),
    collection("chi", () => [...state.children.map(childName), ...madeChildren(state)]),
    collection("port", () => portNames(state)),
    collection("svc", () => namesOfServices(services, known), known.length === 0),
  ];
  return { kind: "condition", names: [...own, ...languageNames] };
}
