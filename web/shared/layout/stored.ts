// The panels as a text, for the storage of the browser. What cannot be read is as usual.
import { kUsualPanels, panelNames, type CellPlace, type FoldedPanel, type Panels } from "./panels";

export const panelsText = (panels: Panels): string => JSON.stringify({ ...panels, folded: [...panels.folded] });

const kPlaces: readonly CellPlace[] = ["column", "half"];
const kFolded: readonly FoldedPanel[] = ["left", "right"];

const isSize = (value: unknown): value is number => typeof value === "number" && Number.isFinite(value) && value > 0;
const partOf = (value: object, name: string): unknown => Object.getOwnPropertyDescriptor(value, name)?.value;

function parsed(text: string): unknown {
  try {
    return JSON.parse(text);
  } catch {
    return undefined;
  }
}

export function readPanels(text: string | null): Panels {
  const stored = text === null ? undefined : parsed(text);
  if (typeof stored !== "object" || stored === null) return kUsualPanels;
  const [sizes, folded, cell] = [partOf(stored, "sizes"), partOf(stored, "folded"), partOf(stored, "cell")];
  const entries = typeof sizes === "object" && sizes !== null ? panelNames.map((name) => [name, partOf(sizes, name)] as const) : [];
  return {
    sizes: Object.fromEntries(entries.filter((entry) => isSize(entry[1]))),
    folded: new Set(Array.isArray(folded) ? kFolded.filter((name) => folded.includes(name)) : []),
    cell: kPlaces.find((place) => place === cell) ?? kUsualPanels.cell,
    cellShown: partOf(stored, "cellShown") !== false,
  };
}
