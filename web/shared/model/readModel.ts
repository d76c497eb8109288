// A document as the pages use it: lists that may be absent in its JSON are empty here, and each node has its kind.
import type { Document, RcmAction, RcmBarrier, RcmDeclaration, RcmParameter, RcmPort, RcmState } from "../../generated/messages";
import { SchemaError } from "../messages/check";
import type { Action, Barrier, ConditionPort, Declaration, Node, Parameter, Port, RcmDocument, State, TimedPort } from "./model";

type Optional<T> = { readonly [K in keyof T]: T[K] | undefined };

/** Leaves out the fields that are undefined, as optional properties demand. */
function present<T extends object>(fields: Optional<T>): T {
  return Object.fromEntries(Object.entries(fields).filter(([, value]) => value !== undefined)) as T;
}

const readParameter = ({ name, value, from, unit, doc, meta }: RcmParameter): Parameter => present<Parameter>({ id: meta?.id, name, value, from, unit, doc });
const readDeclaration = ({ name, initial, meta }: RcmDeclaration): Declaration => present<Declaration>({ id: meta?.id, name, initial });
const readAction = ({ when, do: code, meta }: RcmAction): Action => present<Action>({ id: meta?.id, when, do: code });
const readBarrier = ({ barrier, to, meta }: RcmBarrier): Barrier => present<Barrier>({ kind: "barrier", id: meta?.id, name: barrier, to });

/** Only a port of a link may do without condition and time-out, and a native model has no links. */
function readPort({ name, when, after, to, meta }: RcmPort): Port {
  const port = { id: meta?.id, name, to };
  if (after === undefined) {
    if (when === undefined) throw new SchemaError(`/${name}/when`, "the condition of a port", when);
    return present<ConditionPort>({ ...port, when, after });
  }
  if (when !== undefined) throw new SchemaError(`/${name}/after`, "no time-out beside a condition", after);
  return present<TimedPort>({ ...port, when, after });
}

const readNode = (node: RcmState | RcmBarrier): Node => ("barrier" in node ? readBarrier(node) : readState(node));

function readState(state: RcmState): State {
  return present<State>({
    kind: "state",
    id: state.meta?.id,
    name: state.state,
    doc: state.doc,
    parameters: (state.parameters ?? []).map(readParameter),
    results: (state.results ?? []).map(readDeclaration),
    variables: (state.variables ?? []).map(readDeclaration),
    entry: state.entry,
    exit: state.exit,
    actions: (state.actions ?? []).map(readAction),
    children: (state.children ?? []).map(readNode),
    first: state.first,
    ports: (state.ports ?? []).map(readPort),
    link: state.link,
    keepsDeep: typeof state.keep === "object" && "deep" in state.keep ? true : undefined,
    oracle: state.oracle?.kind,
    dispatcher: undefined,
  });
}

export function readModel({ name = "", services = {}, library = [], root }: Document): RcmDocument {
  return { name, services, library: library.map(readState), root: readState(root) };
}
