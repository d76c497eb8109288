// What a topic of the help is made of. In texts, code stands in backquotes.
import type { Example } from "./examples";
import type { LegendGroup } from "./legend";

export type Block =
  | { readonly kind: "text"; readonly text: string }
  | { readonly kind: "list"; readonly items: readonly string[] }
  | { readonly kind: "code"; readonly text: string }
  /** Names with what they mean. */
  | { readonly kind: "terms"; readonly terms: readonly Term[] }
  | { readonly kind: "figure"; readonly example: Example; readonly caption: string }
  /** The signs of the drawing and of the cell. */
  | { readonly kind: "legend"; readonly groups: readonly LegendGroup[] }
  | { readonly kind: "heading"; readonly text: string }
  /** All keys and mouse actions of the page. */
  | { readonly kind: "keys" };

export interface Term {
  readonly name: string;
  readonly text: string;
  /** By which it is found again: `error-scope`. */
  readonly id?: string;
}

export const groups = ["First steps", "Tasks", "Runs", "Function language", "Server", "Reference"] as const;

export interface Topic {
  /** In the address. */
  readonly id: string;
  readonly title: string;
  readonly group: (typeof groups)[number];
  readonly blocks: readonly Block[];
}

export const text = (words: string): Block => ({ kind: "text", text: words });
export const list = (...items: readonly string[]): Block => ({ kind: "list", items });
export const code = (...lines: readonly string[]): Block => ({ kind: "code", text: lines.join("\n") });
export const heading = (words: string): Block => ({ kind: "heading", text: words });
export const terms = (...all: readonly (readonly [name: string, text: string])[]): Block => ({ kind: "terms", terms: all.map(([name, words]) => ({ name, text: words })) });
export const figure = (example: Example, caption: string): Block => ({ kind: "figure", example, caption });
