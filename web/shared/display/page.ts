// The state of a display page as a value, and the function that applies an event to it.
import { assertNever } from "../assertNever";
import type { Display } from "../../generated/messages";
import type { Connection } from "../stream";
import { press, proposed, type Key } from "./numberText";

export interface DisplayPage {
  readonly name: string;
  readonly connection: Connection;
  readonly content: Display | undefined;
  /** What has been entered for the question that asks for a number. */
  readonly entry: string;
  /** An answer was sent: the question takes no second one. */
  readonly sent: boolean;
  /** The page was touched, so the browser lets it play sounds. */
  readonly sound: boolean;
  /** Why the server refuses this page as a display. */
  readonly problem: string | undefined;
}

export type DisplayEvent =
  | { readonly type: "connection"; readonly connection: Connection }
  | { readonly type: "content"; readonly content: Display }
  | { readonly type: "key"; readonly key: Key }
  | { readonly type: "sent" }
  | { readonly type: "sound" }
  | { readonly type: "problem"; readonly text: string };

export const kDefaultName = "main";

/** The display's name in the address, `?name=`; undefined if it is none (see api/schemas/display.json). */
export function nameOf(search: string): string | undefined {
  const name = new URLSearchParams(search).get("name") ?? kDefaultName;
  return /^[A-Za-z0-9_-]{1,32}$/.test(name) && name !== "all" ? name : undefined;
}

/** The place where the display is, `?place=` in the address; undefined if there is none. The server refuses one that cannot be. */
export const placeOf = (search: string): string | undefined => new URLSearchParams(search).get("place") ?? undefined;

export const firstPage = (name: string): DisplayPage => ({
  name,
  connection: "connecting",
  content: undefined,
  entry: "",
  sent: false,
  sound: false,
  problem: undefined,
});

export function applyDisplayEvent(page: DisplayPage, event: DisplayEvent): DisplayPage {
  switch (event.type) {
    case "connection":
      return { ...page, connection: event.connection, sent: false };
    case "content":
      return withContent(page, event.content);
    case "key":
      return { ...page, entry: press(page.entry, event.key) };
    case "sent":
      return { ...page, sent: true };
    case "sound":
      return { ...page, sound: true };
    case "problem":
      return { ...page, problem: event.text };
    default:
      return assertNever(event);
  }
}

/** The entry is kept while the question stays the same. */
function withContent(page: DisplayPage, content: Display): DisplayPage {
  const question = content.question;
  const shown = { ...page, content, problem: undefined };
  if (question !== undefined && question.id === page.content?.question?.id) return shown;
  return { ...shown, sent: false, entry: question !== undefined && "number" in question ? proposed(question.number) : "" };
}

/** Whether the user can answer now. */
export const canAnswer = (page: DisplayPage): boolean => page.connection === "open" && !page.sent;
