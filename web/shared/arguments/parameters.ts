// The parameters of a run: those of the root, or of the library state that it links.
import type { Document, RcmParameter, RcmState } from "../../generated/messages";
import { writeExact, type Exact } from "../edit/exact";
import type { Type } from "./mismatch";

export interface RunParameter {
  readonly name: string;
  readonly type: Type;
  /** The value without an argument, as JSON, with its numbers as they are written; nothing: an argument is required. */
  readonly initial: string | undefined;
  readonly unit: string | undefined;
  readonly doc: string | undefined;
  /** Bounds of a number, from the parameter's `meta`. */
  readonly min: number | undefined;
  readonly max: number | undefined;
}

/** A document with the numbers as they are written. */
export type ExactDocument = Exact<Document>;
type Parameter = Exact<RcmParameter>;
type State = Exact<RcmState>;

/** Of a link: those of the library state, with what the link says about them. */
function declared(state: State, library: readonly State[]): readonly Parameter[] {
  const own = state.parameters ?? [];
  const linked = library.find((each) => each.state === state.link);
  if (linked === undefined) return own;
  const rest = library.filter((each) => each !== linked);
  return declared(linked, rest).map((parameter) => ({ ...parameter, ...own.find(({ name }) => name === parameter.name) }));
}

/** A number beside the id of an element; what is written in another way is no bound. */
function bound(meta: Parameter["meta"], name: string): number | undefined {
  const value: unknown = typeof meta === "object" ? Reflect.get(meta, name) : undefined;
  const number = Number(value === undefined ? Number.NaN : writeExact(value));
  return Number.isFinite(number) ? number : undefined;
}

export function runParameters({ root, library = [] }: ExactDocument): readonly RunParameter[] {
  return declared(root, library).map(({ name, type, value, unit, doc, meta }) => ({
    name, unit, doc, initial: value === undefined ? undefined : writeExact(value), min: bound(meta, "min"), max: bound(meta, "max"), type: type ?? "any",
  }));
}

/** Whether a run can be made without asking for arguments. */
export const areOptional = (parameters: readonly RunParameter[]): boolean => parameters.every(({ initial }) => initial !== undefined);
