// Hands at the cell (api/schemas: person, person_command). Metres and newtons in o; points are in the frame of their body.
import { array, object, present, string, type Decoder } from "../json/decode";
import { triple, type Triple } from "./pose";

/** A hand that holds something, or a push under way (which has no target). */
export interface Touch {
  readonly hand: string;
  readonly body: string;
  readonly at: Triple;
  readonly force: Triple;
  readonly target?: Triple;
}

export interface Person {
  readonly hands: readonly Touch[];
  /** Parts that were taken away. */
  readonly absent: readonly string[];
}

/** What a page lets a person do; `place` puts a part back where it was taken away. */
export type PersonCommand =
  | { readonly act: "grab"; readonly hand: string; readonly body: string; readonly point: Triple }
  | { readonly act: "drag"; readonly hand: string; readonly to: Triple }
  | { readonly act: "release"; readonly hand: string }
  | { readonly act: "place"; readonly part: string }
  | { readonly act: "take"; readonly part: string };

export const touches: Decoder<readonly Touch[]> = array(
  object((f) =>
    present<Touch>({
      hand: f.need("hand", string),
      body: f.need("body", string),
      at: f.need("at", triple),
      force: f.need("force", triple),
      target: f.maybe("target", triple),
    }),
  ),
);

export const person: Decoder<Person> = object((f) => ({
  hands: f.need("hands", touches),
  absent: f.need("absent", array(string)),
}));
