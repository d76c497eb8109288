// A message of the file: what is said on a channel, and when.
import type { SchemaName } from "./schemas";

export interface McapChannel {
  readonly topic: string;
  readonly schema: SchemaName;
}

/** Times: [us] since 1970, UTC, integers. */
export interface McapMessage {
  readonly channel: McapChannel;
  readonly time: number;
  /** When it was said, if that is known to be earlier. */
  readonly published?: number;
  /** As the schema of the channel says. */
  readonly value: object;
}

const kSecond = 1e6;

/** A time as Foxglove's schemas have it. */
export const stampOf = (time: number): { readonly sec: number; readonly nsec: number } => ({ sec: Math.floor(time / kSecond), nsec: (time % kSecond) * 1000 });
