// What is compared: two revisions of a document, or one with the document as it is now.

export interface Range {
  /** The earlier revision. */
  readonly from: number;
  /** The later one; nothing: the document as it is now. */
  readonly to: number | undefined;
}

/** `14..`: what has changed since revision 14; `13..14`: what has changed between them. */
export const rangeText = ({ from, to }: Range): string => `${from}..${to ?? ""}`;

/** A range as an address has it; nothing: it is none. */
export function readRange(text: string): Range | undefined {
  const found = /^([1-9]\d{0,8})\.\.([1-9]\d{0,8})?$/.exec(text);
  if (found === null) return undefined;
  const [from, to] = [Number(found[1]), found[2] === undefined ? undefined : Number(found[2])];
  return to === undefined || from < to ? { from, to } : undefined;
}

export const isSameRange = (one: Range | undefined, other: Range | undefined): boolean => one?.from === other?.from && one?.to === other?.to;
