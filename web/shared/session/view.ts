// The view of the task (selection, folding, panels) as a value, and the function that applies a gesture to it.
import { assertNever } from "../assertNever";
import { commonLevel } from "../drawing/follow";
import type { Detail } from "../drawing/measure";
import { timedElement } from "../model/afters";
import { carried, carriedPath, type Selection } from "../model/identity";
import type { Asked, Subject } from "../run/subject";
import { ancestry, portAt, splitAddress, type ModelTree } from "../model/modelTree";

export type { Selection };

/** What a model has at `address`: a node's path, or a port's `Root/A.success`; of what is a part of another element, that; nothing if it has none. */
export function selectionAt(tree: ModelTree, address: string): Selection | undefined {
  if (tree.has(address)) return { kind: "node", path: address };
  if (portAt(tree, address) !== undefined) return { kind: "port", address };
  const whole = timedElement(tree, address);
  return whole === undefined ? undefined : selectionAt(tree, whole);
}

/** `edit`: the document that is edited. */
export type Page = "task" | "services" | "cell" | "edit";
/** The page of this name that an address may ask for: that of a document is asked for by the document. */
export const pageOf = (name: string | undefined): Page | undefined => (["task", "services", "cell"] as const).find((page) => page === name);

export type Drawer = "derivation" | "timeline" | "calls" | "log" | "manual" | "closed";

/** What a view says of elements of the model that is shown. */
export type Places = Pick<View, "selection" | "also" | "focus" | "collapsed">;

export interface View {
  readonly page: Page;
  readonly drawer: Drawer;
  /** What the drawer showed last. */
  readonly lastDrawer: Exclude<Drawer, "closed">;
  readonly selection: Selection | undefined;
  /** Nodes that are selected besides `selection`, by their paths; none unless that is a node. */
  readonly also: ReadonlySet<string>;
  /** What is asked about of the state that is selected, in a run. */
  readonly asked: Asked | undefined;
  /** The state whose inside fills the canvas; none: the root. */
  readonly focus: string | undefined;
  readonly collapsed: ReadonlySet<string>;
  /** `auto`: as much detail as can be read at first fit. */
  readonly detail: "auto" | Detail;
  /** Increases when the canvas has to reveal the selection. */
  readonly reveal: number;
  /** The macro step whose derivation is shown; none: the latest. */
  readonly step: number | undefined;
  /** What is shown of that derivation; none: its beginning. */
  readonly inference: WantedInference | undefined;
  /** Whether the keys and mouse actions are shown over the page. */
  readonly help: boolean;
  /** Whether the documents are shown over the page. */
  readonly documents: boolean;
  /** Whether the stored runs are. */
  readonly runs: boolean;
  /** Whether the drawing of a run goes to what becomes active. */
  readonly follow: boolean;
  /** Whether a run of the document that is edited is shown on its drawing. */
  readonly runShown: boolean;
  /** The places of the other model: of the document that is edited while a run is shown, and the other way round. */
  readonly aside: Places;
}

/** A micro step of the derivation that is shown, and what the inference is of that is picked in it. */
export interface WantedInference {
  /** Micro steps of the macro step that come before. */
  readonly micro: number;
  readonly of?: Subject;
}

/** The part of a view on which a drawing depends. */
export type Shown = Pick<View, "focus" | "collapsed" | "detail">;

export type Gesture =
  | { readonly type: "page"; readonly page: Page }
  | { readonly type: "drawer"; readonly drawer: Drawer }
  /** Closes the drawer, or opens it with what it showed last. */
  | { readonly type: "toggle_drawer" }
  | { readonly type: "select"; readonly selection: Selection | undefined }
  /** Selects a node besides the others, or no longer. */
  | { readonly type: "select_also"; readonly path: string }
  | { readonly type: "select_all"; readonly paths: readonly string[] }
  | { readonly type: "jump"; readonly selection: Selection }
  /** Why an action of the state that is selected is executed or not, or what gives a parameter its value. */
  | { readonly type: "ask"; readonly asked: Asked | undefined }
  /** Shows a place in the model, and what is below. */
  | { readonly type: "place"; readonly focus: string | undefined; readonly selection: Selection | undefined; readonly asked: Asked | undefined; readonly drawer: Drawer }
  | { readonly type: "enter"; readonly path: string | undefined }
  | { readonly type: "toggle"; readonly path: string }
  /** Whether the drawing of a run follows it; a user who goes elsewhere ends that. */
  | { readonly type: "follow"; readonly on: boolean }
  /** Shows the level, and opens the states, in which these nodes are drawn. */
  | { readonly type: "show_active"; readonly paths: readonly string[] }
  | { readonly type: "collapse_all"; readonly paths: readonly string[] }
  | { readonly type: "expand_all" }
  | { readonly type: "detail"; readonly detail: View["detail"] }
  | { readonly type: "show_again"; readonly shown: Shown }
  /** Of a run, also while a document is edited: then it is seen on the other pages. */
  | { readonly type: "show_run"; readonly shown: Shown }
  | { readonly type: "step"; readonly step: number | undefined; readonly inference?: WantedInference }
  /** The same, and the drawer stays as it is. */
  | { readonly type: "turn_to_step"; readonly step: number | undefined; readonly inference?: WantedInference | undefined }
  | { readonly type: "help"; readonly shown: boolean }
  | { readonly type: "documents"; readonly shown: boolean }
  | { readonly type: "runs"; readonly shown: boolean }
  | { readonly type: "run_shown"; readonly shown: boolean }
  | { readonly type: "escape" }
  /** Another model is shown on this page. */
  | { readonly type: "forget" }
  /** Another run is watched. */
  | { readonly type: "forget_run" }
  /** The model of the edited document, or of the run, is another now: what the view says of the elements of `before` it says of the same ones in
   *  `after`. */
  | { readonly type: "carry"; readonly of: "document" | "run"; readonly before: ModelTree; readonly after: ModelTree };

const kNone: ReadonlySet<string> = new Set();
const kNowhere: Places = { selection: undefined, also: kNone, focus: undefined, collapsed: kNone };

export const initialView: View = {
  page: "task",
  drawer: "derivation",
  lastDrawer: "derivation",
  ...kNowhere,
  asked: undefined,
  detail: "auto",
  reveal: 0,
  step: undefined,
  inference: undefined,
  help: false,
  documents: false,
  runs: false,
  follow: false,
  runShown: true,
  aside: kNowhere,
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

/** The nodes that are selected, the first of them first; none if a port is. */
export const selectedPaths = ({ selection, also }: Pick<View, "selection" | "also">): readonly string[] => (selection?.kind === "node" ? [selection.path, ...also] : []);

function selectAll(view: View, [first, ...others]: readonly string[]): View {
  return { ...view, selection: first === undefined ? undefined : { kind: "node", path: first }, also: new Set(others), asked: undefined };
}

function selectAlso(view: View, path: string): View {
  const paths = selectedPaths(view);
  return selectAll(view, paths.includes(path) ? paths.filter((each) => each !== path) : [...paths, path]);
}

/** The view on another page; each of the two models keeps its places. */
function toPage(view: View, page: Page): View {
  if ((page === "edit") === (view.page === "edit")) return { ...view, page };
  const { selection, also, focus, collapsed } = view;
  return { ...view, ...view.aside, page, aside: { selection, also, focus, collapsed } };
}

function carry(view: Places, before: ModelTree, after: ModelTree): Places {
  const paths = (all: Iterable<string>) => new Set([...all].map((path) => carriedPath(before, after, path)).filter((path) => path !== undefined));
  const selection = view.selection && carried(before, after, view.selection);
  const also = view.also.size === 0 ? view.also : paths(view.also);
  return {
    selection: selection ?? (also.size > 0 ? { kind: "node", path: [...also][0] ?? "" } : undefined),
    also: selection === undefined ? new Set([...also].slice(1)) : also,
    focus: view.focus === undefined ? undefined : carriedPath(before, after, view.focus),
    collapsed: view.collapsed.size === 0 ? view.collapsed : paths(view.collapsed),
  };
}

function toPlace(view: View, { focus, selection, asked }: Pick<View, "focus" | "selection" | "asked">): View {
  const opened = new Set([...(selection === undefined ? [] : ancestry(pathOf(selection)).slice(0, -1)), focus]);
  return { ...view, focus, selection, asked, also: kNone, collapsed: new Set([...view.collapsed].filter((path) => !opened.has(path))), reveal: selection === undefined ? view.reveal : view.reveal + 1 };
}

function within(path: string, focus: string | undefined): boolean {
  return focus === undefined || path === focus || path.startsWith(`${focus}/`);
}

function showActive(view: View, paths: readonly string[]): View {
  const level = commonLevel(paths);
  const focus = paths.every((path) => within(path, view.focus)) ? view.focus : level.includes("/") ? level : undefined;
  const opened = new Set(paths.flatMap((path) => ancestry(path).slice(0, -1)));
  const collapsed = [...view.collapsed].filter((path) => !opened.has(path));
  return { ...view, focus, collapsed: collapsed.length === view.collapsed.size ? view.collapsed : new Set(collapsed) };
}

/** The page with a drawing that a place in the model is shown on: the one that is open, else the task. */
const modelPage = ({ page }: View): Page => (page === "edit" ? "edit" : "task");

/** Whether something is shown over the page. */
const isCovered = ({ help, documents, runs }: View): boolean => help || documents || runs;

export function applyGesture(view: View, gesture: Gesture): View {
  switch (gesture.type) {
    case "page":
      return toPage(view, gesture.page);
    case "drawer":
      return { ...view, drawer: gesture.drawer, lastDrawer: gesture.drawer === "closed" ? view.lastDrawer : gesture.drawer };
    case "toggle_drawer":
      return { ...view, drawer: view.drawer === "closed" ? view.lastDrawer : "closed" };
    case "select":
      return { ...view, selection: gesture.selection, also: kNone, asked: undefined };
    case "ask":
      return { ...view, asked: gesture.asked };
    case "select_also":
      return selectAlso(view, gesture.path);
    case "select_all":
      return selectAll(view, gesture.paths);
    case "jump": {
      const path = pathOf(gesture.selection);
      const opened = new Set(ancestry(path).slice(0, -1));
      return {
        ...view,
        page: modelPage(view),
        selection: gesture.selection,
        also: kNone,
        asked: undefined,
        focus: within(path, view.focus) ? view.focus : undefined,
        collapsed: new Set([...view.collapsed].filter((entry) => !opened.has(entry))),
        reveal: view.reveal + 1,
        follow: false,
      };
    }
    case "place":
      return toPlace(applyGesture(view, { type: "drawer", drawer: gesture.drawer }), gesture);
    case "enter":
      return { ...view, page: modelPage(view), focus: gesture.path, collapsed: new Set([...view.collapsed].filter((p) => p !== gesture.path)), follow: false };
    case "toggle": {
      const collapsed = new Set(view.collapsed);
      if (!collapsed.delete(gesture.path)) collapsed.add(gesture.path);
      return { ...view, collapsed, follow: false };
    }
    case "follow":
      return { ...view, follow: gesture.on };
    case "show_active":
      return showActive(view, gesture.paths);
    case "collapse_all":
      return { ...view, collapsed: new Set(gesture.paths), follow: false };
    case "expand_all":
      return { ...view, collapsed: new Set() };
    case "detail":
      return { ...view, detail: gesture.detail };
    case "show_again":
      return { ...view, ...gesture.shown };
    case "show_run": {
      const { detail, ...places } = gesture.shown;
      return view.page === "edit" ? { ...view, aside: { ...view.aside, ...places } } : { ...view, detail, ...places };
    }
    case "step":
      return { ...view, step: gesture.step, inference: gesture.inference, drawer: "derivation", lastDrawer: "derivation" };
    case "turn_to_step":
      return { ...view, step: gesture.step, inference: gesture.inference };
    case "help":
      return { ...view, help: gesture.shown };
    case "documents":
      return { ...view, documents: gesture.shown };
    case "runs":
      return { ...view, runs: gesture.shown };
    case "run_shown":
      return { ...view, runShown: gesture.shown };
    case "escape":
      if (isCovered(view)) return { ...view, help: false, documents: false, runs: false };
      return { ...view, selection: undefined, also: kNone, asked: undefined };
    case "carry": {
      const isShown = (view.page === "edit") === (gesture.of === "document");
      return isShown ? { ...view, ...carry(view, gesture.before, gesture.after) } : { ...view, aside: carry(view.aside, gesture.before, gesture.after) };
    }
    case "forget":
      return { ...view, ...kNowhere, asked: undefined, step: undefined, inference: undefined };
    case "forget_run":
      return view.page === "edit" ? { ...view, aside: kNowhere, step: undefined, inference: undefined } : { ...view, ...kNowhere, asked: undefined, step: undefined, inference: undefined };
    default:
      return assertNever(gesture);
  }
}
