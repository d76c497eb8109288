// Why a port fired or does not fire (api/schemas/why.json).
import { array, boolean, json, object, present, string, type Decoder, type JsonValue } from "../json/decode";

/** Three-valued (R2): null is unknown. */
export type Truth = boolean | null;

export interface WhyAtom {
  readonly text: string;
  readonly value: Truth;
  /** It reads service data. */
  readonly service: boolean;
  /** Its change alone would make the condition true. */
  readonly blocks: boolean;
  readonly requires: readonly string[];
  /** Names that it reads, with what is there now, if anything. */
  readonly reads: readonly { readonly text: string; readonly value?: JsonValue }[];
  /** What it would have to become. */
  readonly wanted?: boolean;
  /** Not alone, but with the others that are marked so, its change would make the condition true. */
  readonly together: boolean;
}

export interface Why {
  readonly port: string;
  readonly condition: string;
  readonly value: Truth;
  /** The port has fired and is active. */
  readonly active: boolean;
  readonly stateActive: boolean;
  readonly reason: string;
  readonly atoms: readonly WhyAtom[];
  /** Refinement that holds the port back although its condition is true. */
  readonly held?: string;
}

const truth: Decoder<Truth> = (value, path) => (value === null ? null : boolean(value, path));

const read: Decoder<WhyAtom["reads"][number]> = object((r) =>
  present<WhyAtom["reads"][number]>({ text: r.need("text", string), value: r.maybe("value", json) }),
);

export const why: Decoder<Why> = object((f) =>
  present<Why>({
    port: f.need("port", string),
    condition: f.need("condition", string),
    value: f.need("value", truth),
    active: f.need("active", boolean),
    stateActive: f.need("state_active", boolean),
    reason: f.need("reason", string),
    atoms: f.need(
      "atoms",
      array(
        object((a) =>
          present<WhyAtom>({
            text: a.need("text", string),
            value: a.need("value", truth),
            service: a.need("service", boolean),
            blocks: a.need("blocks", boolean),
            requires: a.or("requires", array(string), []),
            reads: a.or("reads", array(read), []),
            wanted: a.maybe("wanted", boolean),
            together: a.or("together", boolean, false),
          }),
        ),
      ),
    ),
    held: f.maybe("held", string),
  }),
);
