// The view of the task (selection, folding, panels) as a value, and the function that applies a gesture to it.
import { assertNever } from "../assertNever";
import type { Detail } from "../drawing/measure";
import { timedElement } from "../model/afters";
import { ancestry, portAt, splitAddress, type ModelTree } from "../model/modelTree";

export type Selection = { readonly kind: "node"; readonly path: string } | { readonly kind: "port"; readonly address: string };

/** What a model has at `address`: a node's path, or a port's `Root/A.success`; of what is a part of another element, that; nothing if it has none. */
export function selectionAt(tree: ModelTree, address: string): Selection | undefined {
  if (tree.has(address)) return { kind: "node", path: address };
  if (portAt(tree, address) !== undefined) return { kind: "port", address };
  const whole = timedElement(tree, address);
  return whole === undefined ? undefined : selectionAt(tree, whole);
}

/** `draft`: the errors of a document. */
export type Page = "task" | "services" | "cell" | "draft";
export type Drawer = "derivation" | "log" | "closed";

export interface View {
  readonly page: Page;
  readonly drawer: Drawer;
  readonly selection: Selection | undefined;
  /** The state whose inside fills the canvas; none: the root. */
  readonly focus: string | undefined;
  readonly collapsed: ReadonlySet<string>;
  /** `auto`: as much detail as can be read at first fit. */
  readonly detail: "auto" | Detail;
  /** Increases when the canvas has to reveal the selection. */
  readonly reveal: number;
  /** The macro step whose derivation is shown; none: the latest. */
  readonly step: number | undefined;
  /** Whether the cell is shown beside the task. */
  readonly inset: boolean;
  /** Whether the keys and mouse actions are shown over the page. */
  readonly help: boolean;
}

/** The part of a view on which a drawing depends. */
export type Shown = Pick<View, "focus" | "collapsed" | "detail">;

export type Gesture =
  | { readonly type: "page"; readonly page: Page }
  | { readonly type: "drawer"; readonly drawer: Drawer }
  | { readonly type: "select"; readonly selection: Selection | undefined }
  | { readonly type: "jump"; readonly selection: Selection }
  | { readonly type: "enter"; readonly path: string | undefined }
  | { readonly type: "toggle"; readonly path: string }
  | { readonly type: "collapse_all"; readonly paths: readonly string[] }
  | { readonly type: "expand_all" }
  | { readonly type: "detail"; readonly detail: View["detail"] }
  | { readonly type: "show_again"; readonly shown: Shown }
  | { readonly type: "step"; readonly step: number | undefined }
  | { readonly type: "inset"; readonly shown: boolean }
  | { readonly type: "help"; readonly shown: boolean }
  | { readonly type: "escape" }
  | { readonly type: "forget" };

export const initialView: View = {
  page: "task",
  drawer: "derivation",
  selection: undefined,
  focus: undefined,
  collapsed: new Set(),
  detail: "auto",
  reveal: 0,
  step: undefined,
  inset: true,
  help: false,
};

/** A window lower than this has room for a task that can be read, or for what lies below it, not for both [px]. */
const kLow = 960;
/** Up to this width the parts of the page stand beneath each other (layout.css) [px]. */
const kNarrow = 760;

/** The view with which a page opens: the task comes first, and the derivation is open too where there is room for both. */
export function firstView(window: { readonly width: number; readonly height: number }): View {
  return window.height < kLow && window.width > kNarrow ? { ...initialView, drawer: "closed" } : initialView;
}

export function pathOf(selection: Selection): string {
  return selection.kind === "node" ? selection.path : (splitAddress(selection.address)?.path ?? selection.address);
}

function within(path: string, focus: string | undefined): boolean {
  return focus === undefined || path === focus || path.startsWith(`${focus}/`);
}

export function applyGesture(view: View, gesture: Gesture): View {
  switch (gesture.type) {
    case "page":
      return { ...view, page: gesture.page };
    case "drawer":
      return { ...view, drawer: gesture.drawer };
    case "select":
      return { ...view, selection: gesture.selection };
    case "jump": {
      const path = pathOf(gesture.selection);
      const opened = new Set(ancestry(path).slice(0, -1));
      return {
        ...view,
        page: "task",
        selection: gesture.selection,
        focus: within(path, view.focus) ? view.focus : undefined,
        collapsed: new Set([...view.collapsed].filter((entry) => !opened.has(entry))),
        reveal: view.reveal + 1,
      };
    }
    case "enter":
      return { ...view, page: "task", focus: gesture.path, collapsed: new Set([...view.collapsed].filter((p) => p !== gesture.path)) };
    case "toggle": {
      const collapsed = new Set(view.collapsed);
      if (!collapsed.delete(gesture.path)) collapsed.add(gesture.path);
      return { ...view, collapsed };
    }
    case "collapse_all":
      return { ...view, collapsed: new Set(gesture.paths) };
    case "expand_all":
      return { ...view, collapsed: new Set() };
    case "detail":
      return { ...view, detail: gesture.detail };
    case "show_again":
      return { ...view, ...gesture.shown };
    case "step":
      return { ...view, step: gesture.step, drawer: "derivation" };
    case "inset":
      return { ...view, inset: gesture.shown };
    case "help":
      return { ...view, help: gesture.shown };
    case "escape":
      if (view.help) return { ...view, help: false };
      return view.page === "draft" ? { ...view, page: "task" } : { ...view, selection: undefined };
    case "forget":
      return { ...initialView, page: view.page === "draft" ? "task" : view.page, drawer: view.drawer, detail: view.detail, inset: view.inset, help: view.help };
    default:
      return assertNever(gesture);
  }
}
