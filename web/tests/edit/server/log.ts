// The edits that a simulated server has accepted (core/edit/log.h).
import type { Edit } from "../../../generated/messages";
import type { Departure } from "./positions";

export interface LogEntry {
  readonly revision: number;
  readonly author: string;
  readonly edit: Edit;
  readonly inverse: Edit;
  readonly kind: "change" | "undo" | "redo";
  /** An undo: what it takes back; a redo: the undo that it takes back. */
  readonly of: number;
  /** Of each operation: the place that its element left. */
  readonly departures: readonly Departure[];
  readonly lastDeparture: Departure;
  /** All elements that came and went. */
  readonly inserted: readonly string[];
  readonly removed: readonly string[];
  /** False: an edit and its undo, which together change nothing. */
  inEffect: boolean;
  /** Of an edit that is not in effect, the undo, and of an undo, the edit. */
  partner: number;
}
