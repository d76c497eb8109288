// A laid out model: what the canvas paints, in pixels at zoom 1, origin at the top left corner.
import type { Line } from "../model/describe";
import type { Dispatcher } from "../model/model";

export interface Point {
  readonly x: number;
  readonly y: number;
}

export interface Box extends Point {
  readonly width: number;
  readonly height: number;
}

/** The border of a state on which its ports stand. */
export type Side = "EAST" | "SOUTH";

export interface DrawnPort extends Box {
  readonly address: string;
  readonly name: string;
  /** As it is written in the drawing: clipped, or empty in a slim drawing. */
  readonly condition: string;
  /** The whole condition, or time-out. */
  readonly when: string;
  /** It has a time-out in place of a condition. */
  readonly timed: boolean;
  /** Without a destination: the port leaves the parent or ends here. */
  readonly exits: boolean;
}

export interface DrawnNode extends Box {
  readonly kind: "state" | "barrier";
  readonly path: string;
  readonly name: string;
  readonly depth: number;
  /** Has children; `open` tells whether they are drawn. */
  readonly composite: boolean;
  readonly open: boolean;
  readonly lines: readonly Line[];
  readonly ports: readonly DrawnPort[];
  readonly side: Side;
  /** Of an open composite: where the content area begins in which its children are placed, from its top left corner. */
  readonly content?: Point;
  readonly badge?: string;
  /** Decides where its parent begins (3.3.2): drawn as a sign, not as a state. */
  readonly dispatcher?: Dispatcher;
}

/** `transition`: port to sibling; `fork`: barrier to state; `first`: composite to child; `exit`: child's port to parent's port; `nowhere`: a port without either. */
export type LineKind = "transition" | "fork" | "first" | "exit" | "nowhere";

export interface DrawnLine {
  readonly id: string;
  readonly kind: LineKind;
  /** Path or port address. */
  readonly from: string;
  readonly to: string | undefined;
  readonly depth: number;
  readonly points: readonly Point[];
}

export interface Drawing {
  readonly nodes: readonly DrawnNode[];
  readonly lines: readonly DrawnLine[];
  readonly width: number;
  readonly height: number;
}
