// The panels of this page: their sizes as properties of the style sheet (`--left`, ...), kept in the storage of the browser.
import { flushSync } from "react-dom";
import { kUsualPanels, panelNames, shownSizes, type CellPlace, type FoldedPanel, type PanelName, type Panels } from "../../shared/layout/panels";
import { panelsText, readPanels } from "../../shared/layout/stored";
import { createStore, useSelected } from "../../page/store";

const kKey = "race.panels";

type Change =
  /** No size: its usual one. */
  | { readonly type: "sized"; readonly panel: PanelName; readonly size: number | undefined }
  | { readonly type: "folded"; readonly panel: FoldedPanel; readonly folded: boolean }
  /** The parts of the page stand beneath each other from now on, or no longer. */
  | { readonly type: "arranged" }
  | { readonly type: "cell"; readonly place?: CellPlace; readonly shown: boolean };

function apply(panels: Panels, change: Change): Panels {
  switch (change.type) {
    case "sized": {
      const { [change.panel]: _, ...others } = panels.sizes;
      return { ...panels, sizes: change.size === undefined ? others : { ...others, [change.panel]: change.size } };
    }
    case "folded":
      return { ...panels, folded: new Set([...panels.folded].filter((panel) => panel !== change.panel).concat(change.folded ? [change.panel] : [])) };
    case "arranged":
      return { ...panels };
    case "cell":
      return { ...panels, cell: change.place ?? panels.cell, cellShown: change.shown };
  }
}

function stored(): Panels {
  try {
    return readPanels(localStorage.getItem(kKey));
  } catch {
    return kUsualPanels;
  }
}

const store = createStore<Panels, Change>(stored(), apply);

export const panelsNow = (): Panels => store.get();
export const usePanels = (): Panels => useSelected(store, (panels) => panels);
export const windowNow = () => ({ width: innerWidth, height: innerHeight });

export const setSize = (panel: PanelName, size: number | undefined): void => store.dispatch({ type: "sized", panel, size });

/** Where the parts of the page stand beneath each other (styles/layout.css), nothing is folded away. */
const beneath = matchMedia("(max-width: 760px)");

/** Whether it is folded away. */
export const useFolded = (panel: FoldedPanel): boolean => useSelected(store, ({ folded }) => folded.has(panel) && !beneath.matches);

export const toggleFolded = (panel: FoldedPanel): void => store.dispatch({ type: "folded", panel, folded: !store.get().folded.has(panel) });

/** Brings the panel back before something in it is shown or gets the focus. */
export function unfold(panel: FoldedPanel): void {
  if (store.get().folded.has(panel)) flushSync(() => toggleFolded(panel));
}

/** Where the cell is shown beside a task, if it is. */
export const useCellPlace = (): CellPlace | undefined => useSelected(store, ({ cell, cellShown }) => (cellShown ? cell : undefined));

/** Shows the cell beside the task, at this place or where it was shown before. */
export const showCell = (place?: CellPlace): void => store.dispatch({ type: "cell", shown: true, ...(place !== undefined && { place }) });
export const hideCell = (): void => store.dispatch({ type: "cell", shown: false });

/** The properties of the style sheet. */
const kProperties: Readonly<Record<PanelName, string>> = {
  left: "--left", right: "--right", drawer: "--drawer", cell: "--cell", cell_half: "--cell-half", steps: "--steps", inference: "--inference", list: "--list",
};

function show(): void {
  const panels = store.get();
  const sizes = shownSizes(panels, windowNow());
  const { style } = document.documentElement;
  for (const name of panelNames) style.setProperty(kProperties[name], `${(name === "left" || name === "right") && panels.folded.has(name) ? 0 : sizes[name]}px`);
}

function keep(): void {
  try {
    localStorage.setItem(kKey, panelsText(store.get()));
  } catch {
    // Local storage is refused: the sizes hold for this page.
  }
}

show();
addEventListener("resize", show);
beneath.addEventListener("change", () => store.dispatch({ type: "arranged" }));
store.listen(() => {
  show();
  keep();
});
