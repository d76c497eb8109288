// Messages about the edits of a document: what a page sends and gets on the stream.
import type { Edit, ServerError } from "../../generated/messages";
import type { JsonObject } from "../json";

/** The state of a document, on its channel. */
export interface DocumentSnapshot {
  readonly document: string;
  readonly revision: number;
  readonly json: JsonObject;
  readonly errors: readonly ServerError[];
}

/** An edit as the server has applied it. */
export interface AcceptedEdit {
  readonly document: string;
  /** Of the document after it. */
  readonly revision: number;
  readonly author: string;
  readonly message: string;
  readonly time: number;
  readonly kind: "change" | "undo" | "redo";
  readonly of?: number;
  readonly request?: string;
  readonly operations: Edit["operations"];
  readonly errors: readonly ServerError[];
  readonly undo: number;
  readonly redo: number;
}

export interface EditRefused {
  readonly document: string;
  readonly request: string;
  readonly errors: readonly ServerError[];
  readonly revision?: number;
  readonly author?: string;
}

/** An edit that the server makes on its own document. */
export interface EditCompound {
  readonly kind: "duplicate";
  readonly id: string;
}

interface EditRequest {
  readonly type: "edit";
  readonly document: string;
  readonly request: string;
  readonly revision: number;
  readonly author?: string;
  readonly message?: string;
}

export type EditMessage = EditRequest & ({ readonly operations: Edit["operations"] } | { readonly compound: EditCompound } | { readonly undo: true } | { readonly redo: true });

export type StreamRequest = { readonly type: "subscribe"; readonly channel: string; readonly since?: number } | EditMessage;
