// A model document from the server, parsed. The server has checked the constraints; here only the shape counts.
import { array, json, number, object, present, record, string, type Decoder } from "../json/decode";
import type { Action, Barrier, Node, Parameter, Port, RcmDocument, Slot, State } from "./model";

const parameter: Decoder<Parameter> = object((f) =>
  present<Parameter>({
    name: f.need("name", string),
    value: f.maybe("value", json),
    from: f.maybe("from", string),
    unit: f.maybe("unit", string),
    doc: f.maybe("doc", string),
  }),
);

const slot: Decoder<Slot> = object((f) =>
  present<Slot>({ name: f.need("name", string), initial: f.maybe("initial", json) }),
);

const action: Decoder<Action> = object((f) => ({ when: f.need("when", string), do: f.need("do", string) }));

const port: Decoder<Port> = object((f) =>
  present<Port>({ name: f.need("name", string), when: f.need("when", string), to: f.maybe("to", string) }),
);

const barrier: Decoder<Barrier> = object((f) => ({
  kind: "barrier" as const,
  name: f.need("barrier", string),
  to: f.need("to", array(string)),
}));

const node: Decoder<Node> = (value, path) =>
  object((f) => f.has("barrier"))(value, path) ? barrier(value, path) : state(value, path);

const oracleKind: Decoder<string> = object((f) => f.need("kind", string));

export const state: Decoder<State> = object((f) =>
  present<State>({
    kind: "state",
    name: f.need("state", string),
    doc: f.maybe("doc", string),
    parameters: f.or("parameters", array(parameter), []),
    results: f.or("results", array(slot), []),
    variables: f.or("variables", array(slot), []),
    entry: f.maybe("entry", string),
    exit: f.maybe("exit", string),
    actions: f.or("actions", array(action), []),
    children: f.or("children", array(node), []),
    first: f.maybe("first", string),
    ports: f.or("ports", array(port), []),
    link: f.maybe("link", string),
    oracle: f.maybe("oracle", oracleKind),
  }),
);

/** A whole document. */
export const rcmDocument: Decoder<RcmDocument> = object((f) => {
  f.need("rcm", number);
  return {
    name: f.or("name", string, ""),
    services: f.or("services", record(string), {}),
    library: f.or("library", array(state), []),
    root: f.need("root", state),
  };
});
