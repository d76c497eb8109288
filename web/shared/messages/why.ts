// Why a port fired or does not fire (api/schemas/why.json).
import { array, boolean, object, present, string, type Decoder } from "../json/decode";

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
        object((a) => ({
          text: a.need("text", string),
          value: a.need("value", truth),
          service: a.need("service", boolean),
          blocks: a.need("blocks", boolean),
          requires: a.or("requires", array(string), []),
        })),
      ),
    ),
    held: f.maybe("held", string),
  }),
);
