// What a display shows (api/schemas/display.json), and what a display says to the server.
import { array, number, object, present, string, type Decoder } from "../json/decode";

/** Stays until another one comes. */
export interface Message {
  readonly text: string;
  /** A data URL. */
  readonly image?: string;
  readonly buttons: readonly string[];
}

/** What a number must be, ends included; `value` is proposed. */
export interface NumberEntry {
  readonly unit: string;
  readonly min: number;
  readonly max: number;
  readonly value?: number;
}

export type Question =
  | { readonly kind: "buttons"; readonly id: number; readonly text: string; readonly buttons: readonly string[] }
  | { readonly kind: "number"; readonly id: number; readonly text: string; readonly number: NumberEntry };

/** To be played once for each id. */
export interface Sound {
  readonly id: number;
  readonly name: string;
  /** 0..1 */
  readonly volume: number;
  readonly repeat: number;
}

export interface Content {
  readonly display: string;
  readonly message?: Message;
  readonly question?: Question;
  readonly sound?: Sound;
}

export type DisplayRequest =
  | { readonly type: "display"; readonly name: string; readonly sound: boolean }
  | { readonly type: "answer"; readonly question: number; readonly answer: string | number }
  | { readonly type: "press"; readonly button: string }
  | { readonly type: "played"; readonly sound: number };

const message: Decoder<Message> = object((f) =>
  present<Message>({ text: f.need("text", string), image: f.maybe("image", string), buttons: f.need("buttons", array(string)) }),
);

const numberEntry: Decoder<NumberEntry> = object((f) =>
  present<NumberEntry>({
    unit: f.need("unit", string),
    min: f.need("min", number),
    max: f.need("max", number),
    value: f.maybe("value", number),
  }),
);

const question: Decoder<Question> = object((f) => {
  const common = { id: f.need("id", number), text: f.need("text", string) };
  const entry = f.maybe("number", numberEntry);
  if (entry !== undefined) return { kind: "number", ...common, number: entry };
  return { kind: "buttons", ...common, buttons: f.need("buttons", array(string)) };
});

const sound: Decoder<Sound> = object((f) => ({
  id: f.need("id", number),
  name: f.need("name", string),
  volume: f.need("volume", number),
  repeat: f.need("repeat", number),
}));

export const content: Decoder<Content> = object((f) =>
  present<Content>({
    display: f.need("display", string),
    message: f.maybe("message", message),
    question: f.maybe("question", question),
    sound: f.maybe("sound", sound),
  }),
);
