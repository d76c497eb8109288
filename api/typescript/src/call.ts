// A request that was not sent yet: `calls` has a function for each route that makes one, request.ts sends it.
import type { Validator } from "./check.js";
import type { Exact } from "./exact.js";

/** JSON that is written already, such as a file: it is sent as it is. */
export class RawJson {
  constructor(readonly content: string | Blob) {}
}

/** A body: with numbers as they were written, where that matters (exact.ts). */
export type Body<T> = T | Exact<T> | RawJson;

/** What is undefined is left out. */
export type Fields = Readonly<Record<string, boolean | number | string | undefined>>;

/** One request, and the validator of its answer; `text`: the answer is no JSON. */
export interface Call<Answer> {
  readonly method: "DELETE" | "GET" | "POST" | "PUT";
  readonly path: string;
  readonly query?: Fields;
  readonly headers?: Fields;
  readonly body?: unknown;
  readonly answer: Validator<Answer> | "text";
}

/** A value as one part of a path. Throws a TypeError for `.` and `..`, which are no names, and would lead to another route. */
export function segment(value: number | string): string {
  const text = String(value);
  if (text === "." || text === "..") throw new TypeError(`\`${text}\` is no name`);
  return encodeURIComponent(text);
}

/** Path and query. */
export function targetOf({ path, query = {} }: Pick<Call<unknown>, "path" | "query">): string {
  const given = Object.entries(query).filter(([, value]) => value !== undefined);
  const text = given.map(([name, value]) => `${name}=${encodeURIComponent(String(value))}`).join("&");
  return text === "" ? path : `${path}?${text}`;
}
