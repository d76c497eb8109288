// The panels of the page whose size a user sets: their usual sizes, their bounds in a window, and what keys and drags make of them.
// A size is a width or a height in pixels.

/** `left`, `right`: beside the workspace; `drawer`: below it; `cell`: the cell below the properties; `cell_half`: beside the drawing; `steps`,
 *  `inference`: of the derivation; `list`: what is listed below a document. */
export const panelNames = ["left", "right", "drawer", "cell", "cell_half", "steps", "inference", "list"] as const;
export type PanelName = (typeof panelNames)[number];

/** Panels that are folded away as a whole; the others have buttons of their own. */
export type FoldedPanel = "left" | "right";

/** Where the cell is shown beside a task: below the properties, or in a half of the workspace. */
export type CellPlace = "column" | "half";

export interface Panels {
  /** What the user has set; a panel that is not in it has its usual size. */
  readonly sizes: Readonly<Partial<Record<PanelName, number>>>;
  readonly folded: ReadonlySet<FoldedPanel>;
  readonly cell: CellPlace;
  /** Whether the cell is shown beside a task. */
  readonly cellShown: boolean;
}

export interface Window {
  readonly width: number;
  readonly height: number;
}

export interface Bounds {
  readonly least: number;
  readonly most: number;
}

/** `column`: it is as wide as it is sized, else as high. `title`: of its splitter. */
export interface PanelShape {
  readonly column: boolean;
  readonly title: string;
  readonly least: number;
  readonly usual: (window: Window) => number;
}

const between = (least: number, value: number, most: number): number => Math.max(least, Math.min(most, value));

/** A window up to this width has narrow panels beside the workspace. */
const kNarrow = 1080;
const beside = (narrow: number, share: number, least: number, most: number) => ({ width }: Window) => (width <= kNarrow ? narrow : between(least, Math.round(width * share), most));

export const panelShapes: Readonly<Record<PanelName, PanelShape>> = {
  left: { column: true, title: "Width of the left panel", least: 150, usual: beside(190, 0.125, 236, 320) },
  right: { column: true, title: "Width of the right panel", least: 200, usual: beside(240, 0.165, 300, 420) },
  drawer: { column: false, title: "Height of the panel below", least: 110, usual: ({ height }) => between(170, Math.round(height * 0.27), 340) },
  cell: { column: false, title: "Height of the cell view", least: 120, usual: (window) => Math.round(panelShapes.right.usual(window) * 0.75) },
  cell_half: { column: true, title: "Width of the cell view", least: 200, usual: ({ width }) => Math.round(width * 0.32) },
  steps: { column: true, title: "Width of the macro steps", least: 120, usual: ({ width }) => (width <= kNarrow ? 160 : 250) },
  inference: { column: true, title: "Width of the inference", least: 180, usual: ({ width }) => (width <= kNarrow ? 260 : between(380, Math.round(width * 0.2), 560)) },
  list: { column: false, title: "Height of what is listed below", least: 64, usual: ({ height }) => Math.round(height * 0.2) },
};

export const kUsualPanels: Panels = { sizes: {}, folded: new Set(), cell: "column", cellShown: true };

/** What is left to the workspace, and to the properties over the cell, at least. */
const kWorkspace = { width: 320, height: 170 };
const kProperties = 150;
/** The proof trees between the other two parts of a derivation. */
const kProofs = 220;
/** Height of the top bar and the run bar. */
const kBars = 92;

/** The sizes that all panels have in this window: those that are set, as far as none takes what another part needs. */
export function shownSizes({ sizes, folded }: Panels, window: Window): Readonly<Record<PanelName, number>> {
  const wanted = (name: PanelName) => sizes[name] ?? panelShapes[name].usual(window);
  const shown = {} as Record<PanelName, number>;
  for (const name of panelNames) shown[name] = wanted(name);
  for (const name of panelNames) {
    const { least, most } = boundsIn(name, shown, folded, window);
    shown[name] = between(least, shown[name], most);
  }
  return shown;
}

/** How small and how large a panel may be, beside the others as they are. */
export function boundsOf(name: PanelName, panels: Panels, window: Window): Bounds {
  return boundsIn(name, shownSizes(panels, window), panels.folded, window);
}

function boundsIn(name: PanelName, shown: Readonly<Record<PanelName, number>>, folded: Panels["folded"], window: Window): Bounds {
  const { least } = panelShapes[name];
  const beside = (side: FoldedPanel) => (folded.has(side) ? 0 : Math.max(panelShapes[side].least, Math.min(shown[side], window.width / 2)));
  const most = {
    left: () => window.width - beside("right") - kWorkspace.width,
    right: () => window.width - beside("left") - kWorkspace.width,
    drawer: () => window.height - kBars - kWorkspace.height,
    cell: () => window.height - kBars - kProperties,
    cell_half: () => window.width - beside("left") - beside("right") - kWorkspace.width,
    steps: () => window.width - panelShapes.inference.least - kProofs,
    inference: () => window.width - shown.steps - kProofs,
    list: () => window.height - kBars - 2 * kWorkspace.height,
  }[name]();
  return { least, most: Math.max(least, Math.round(most)) };
}

/** A step of an arrow key, and with Shift. */
const kStep = 16;
const kLargeStep = 80;

/** The size after a key on the splitter; `grows`: the arrow key that makes the panel larger. Nothing: the key is not the splitter's. */
export function sizeByKey(size: number, key: string, shift: boolean, grows: string, { least, most }: Bounds): number | undefined {
  const opposite: Readonly<Record<string, string>> = { ArrowLeft: "ArrowRight", ArrowRight: "ArrowLeft", ArrowUp: "ArrowDown", ArrowDown: "ArrowUp" };
  const step = shift ? kLargeStep : kStep;
  if (key === "Home") return least;
  if (key === "End") return most;
  if (key === grows) return between(least, size + step, most);
  return key === opposite[grows] ? between(least, size - step, most) : undefined;
}
