// The RCM syntax (thesis 3.1) as the pages see it: the document format of core/SEMANTICS.md section 1.
import type { JsonValue } from "../json";

export interface RcmDocument {
  readonly name: string;
  /** svc.<key> -> service type. */
  readonly services: Readonly<Record<string, string>>;
  readonly library: readonly State[];
  readonly root: State;
}

/** What has an id (`meta.id`, core/SEMANTICS.md section 1), which stays the same when it is renamed or moved. */
export interface Identified {
  /** None in a document that was written without ids. */
  readonly id?: string;
}

/** What paths and addresses name. */
interface Keyed {
  readonly name: string;
  /** Its part of a path where that is not its name: siblings of a draft may have the same one (`Grasp#2`). */
  readonly key?: string;
}

/** The part of a path or address that stands for a node or port; no two siblings have the same. */
export const keyOf = ({ name, key }: Keyed): string => key ?? name;

/** The path of a child of the state at `path`. */
export const childPath = (path: string, child: Keyed): string => `${path}/${keyOf(child)}`;

/** The address of a port of the state at `path`. */
export const portAddress = (path: string, port: Keyed): string => `${path}.${keyOf(port)}`;

/** Def. 3.2: `value` is a constant, `from` an expression in the parent's scope; neither: required. */
export interface Parameter extends Identified {
  readonly name: string;
  readonly value?: JsonValue;
  readonly from?: string;
  readonly unit?: string;
  readonly doc?: string;
}

/** What the translation of a history may have added to a state, so that its author has not written it. */
interface Translated {
  readonly made?: true;
}

/** A result (Def. 3.3) or a variable. */
export interface Declaration extends Identified, Translated {
  readonly name: string;
  readonly initial?: JsonValue;
}

/** Def. 3.7. */
export interface Action extends Identified, Translated {
  readonly when: string;
  readonly do: string;
}

interface AnyPort extends Identified, Keyed {
  readonly to?: string;
}

/** A port with a condition. */
export interface ConditionPort extends AnyPort {
  readonly when: string;
  readonly after?: never;
}

/** A port with a time-out: `after` is an expression in the scope of its state, the time [s] after the activation of that. */
export interface TimedPort extends AnyPort {
  readonly when?: never;
  readonly after: string;
}

/** Def. 3.8; `to` names a sibling of the source. */
export type Port = ConditionPort | TimedPort;

/** By what it decides: the child that was active last, alone or with the states inside; an expression or a service. */
export type Dispatcher = "history" | "deep history" | "choice";

/** Def. 3.1. */
export interface State extends Identified, Keyed {
  readonly kind: "state";
  readonly doc?: string;
  readonly parameters: readonly Parameter[];
  readonly results: readonly Declaration[];
  readonly variables: readonly Declaration[];
  readonly entry?: string;
  readonly exit?: string;
  readonly actions: readonly Action[];
  readonly children: readonly Node[];
  readonly first?: string;
  readonly ports: readonly Port[];
  /** Library state that this one takes over (3.3.1). */
  readonly link?: string;
  /** It keeps its values when it is left with its parent, too (R26). */
  readonly keepsDeep?: true;
  /** The expression or call of its dynamic oracle (3.3.2), `history` or `deep history`; of a document that is not translated, the kind. */
  readonly oracle?: string;
  /** Made by the translation of an oracle: decides which sibling is entered first. */
  readonly dispatcher?: Dispatcher;
}

/** Def. 3.9. */
export interface Barrier extends Identified, Keyed {
  readonly kind: "barrier";
  readonly to: readonly string[];
}

export type Node = State | Barrier;
