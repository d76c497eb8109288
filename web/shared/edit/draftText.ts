// Texts of fields that are being written and are not in the document: one for each field that somebody has begun to edit. What happens to
// a draft goes in, the next drafts come out; a text is lost only if its author gives it up, or the document has it.
import { assertNever } from "../assertNever";

/** A field of an element; `id` is empty for the document itself. */
export interface FieldPlace {
  readonly document: string;
  readonly id: string;
  /** As the format names it; of an entry, `field:key`. */
  readonly field: string;
}

export interface DraftText extends FieldPlace {
  readonly text: string;
  /** What the document had when its author began, or what they have decided to replace. */
  readonly base: string;
  /** The text that is on its way to the server. */
  readonly sent?: string;
  /** Why it was not accepted. */
  readonly reason?: string;
}

/** By `keyOfPlace`. */
export type Drafts = ReadonlyMap<string, DraftText>;

/** `now`: what the document has. */
export type DraftEvent =
  | { readonly type: "typed"; readonly place: FieldPlace; readonly text: string; readonly now: string }
  | { readonly type: "given_up"; readonly place: FieldPlace }
  /** Its author has seen what somebody else wrote, and replaces it. */
  | { readonly type: "kept"; readonly place: FieldPlace; readonly now: string }
  | { readonly type: "sent"; readonly place: FieldPlace }
  | { readonly type: "accepted"; readonly place: FieldPlace }
  /** It means nothing, or must not be sent; what is on its way still is. */
  | { readonly type: "not_sent"; readonly place: FieldPlace; readonly reason: string }
  | { readonly type: "refused"; readonly place: FieldPlace; readonly reason: string };

export const noDrafts: Drafts = new Map();

export const keyOfPlace = ({ document, id, field }: FieldPlace): string => `${document}/${id}/${field}`;

/** What somebody else has made of the field since its author began; nothing: what the author knows, or `now` is not known. */
export function theirText({ text, base, sent }: DraftText, now: string | undefined): string | undefined {
  return now === base || now === text || now === sent ? undefined : now;
}

/** Whether something of it is not on its way. */
export const isUnsent = ({ text, sent }: DraftText): boolean => text !== sent;

function typed(draft: DraftText | undefined, { place, text, now }: Extract<DraftEvent, { type: "typed" }>): DraftText | undefined {
  if (draft?.sent === undefined && text === now) return undefined;
  const { document, id, field } = place;
  if (draft === undefined) return { document, id, field, text, base: now };
  const { reason, ...rest } = draft;
  return { ...rest, text };
}

function next(draft: DraftText | undefined, event: DraftEvent): DraftText | undefined {
  if (event.type === "typed") return typed(draft, event);
  if (draft === undefined || event.type === "given_up") return undefined;
  const { sent, reason, ...rest } = draft;
  switch (event.type) {
    case "kept":
      return { ...draft, base: event.now };
    case "sent":
      return { ...rest, sent: rest.text };
    case "accepted":
      return sent === undefined || sent === rest.text ? undefined : { ...rest, base: sent, ...(reason !== undefined && { reason }) };
    case "not_sent":
      return { ...draft, reason: event.reason };
    case "refused":
      return { ...rest, reason: event.reason };
    default:
      return assertNever(event);
  }
}

export function applyDraftEvent(drafts: Drafts, event: DraftEvent): Drafts {
  const key = keyOfPlace(event.place);
  const before = drafts.get(key);
  const after = next(before, event);
  if (after === before) return drafts;
  const changed = new Map(drafts);
  if (after === undefined) changed.delete(key);
  else changed.set(key, after);
  return changed;
}

/** The drafts of a document, those that were begun first first. */
export const draftsOf = (drafts: Drafts, document: string): readonly DraftText[] => [...drafts.values()].filter((draft) => draft.document === document);

export const writeDrafts = (drafts: Drafts): string => JSON.stringify([...drafts.values()]);

/** What writeDrafts wrote. What was on its way may have been lost, so it counts as not sent. Of another text: none. */
export function readDrafts(text: string): Drafts {
  const found = parsed(text);
  if (!Array.isArray(found)) return noDrafts;
  const drafts = found.filter(isDraft).map(({ sent, ...draft }): DraftText => draft);
  return new Map(drafts.map((draft) => [keyOfPlace(draft), draft]));
}

function parsed(text: string): unknown {
  try {
    return JSON.parse(text) as unknown;
  } catch {
    return undefined;
  }
}

const kTexts = ["document", "id", "field", "text", "base"] as const;

function isDraft(value: unknown): value is DraftText {
  if (typeof value !== "object" || value === null) return false;
  const fields = value as Readonly<Record<string, unknown>>;
  return kTexts.every((field) => typeof fields[field] === "string") && (fields["reason"] === undefined || typeof fields["reason"] === "string");
}
