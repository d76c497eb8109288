// The pictures of skills: paths in a square of 24, drawn as lines.
import type { Category } from "./skill";

const kIcons: Readonly<Record<string, string>> = {
  move: "M4 20h6M7 20v-5l5-6 5 3M12 9l-2-4M17 12v4m-2 0h4",
  line: "M4 18 18 6m-6 0h6v6M4 18h.01",
  offset: "M12 3v18M3 12h18M9 6l3-3 3 3M9 18l3 3 3-3M6 9l-3 3 3 3M18 9l3 3-3 3",
  open: "M4 5v8l3 3M20 5v8l-3 3M10 12H7m0 0 2-2m-2 2 2 2M14 12h3m0 0-2-2m2 2-2 2",
  close: "M6 5v8l3 3M18 5v8l-3 3M2 9h4m0 0L4 7m2 2-2 2M22 9h-4m0 0 2-2m-2 2 2 2",
  pick: "M12 2v7m-3-3 3-4 3 4M7 9v5l2 2M17 9v5l-2 2M9 17h6v5H9z",
  place: "M12 2v6m-3-3 3 4 3-4M9 13h6v5H9zM4 21h16",
  search: "M10.5 4a6.5 6.5 0 1 1 0 13 6.5 6.5 0 0 1 0-13zM15.5 15.5 21 21",
  camera: "M4 8h4l2-3h4l2 3h4v11H4zM12 10a3.2 3.2 0 1 1 0 6.4 3.2 3.2 0 0 1 0-6.4z",
  grid: "M4 4h6v6H4zM14 4h6v6h-6zM4 14h6v6H4zM14 14h6v6h-6z",
  hand: "M8 12V5.5a1.5 1.5 0 0 1 3 0V11m0-1V4.5a1.5 1.5 0 0 1 3 0V11m0-4a1.5 1.5 0 0 1 3 0v8a6 6 0 0 1-11 3l-3-5a1.6 1.6 0 0 1 2.6-1.8L8 14",
  ask: "M4 5h16v12h-9l-4 4v-4H4zM10 9a2 2 0 1 1 2.5 2c-.4.2-.5.5-.5 1m0 2.5v.01",
  say: "M4 5h16v12h-9l-4 4v-4H4zM8 9h8M8 13h5",
  handover: "M3 16l4-4h4l3 2M3 20h9l7-6M14 4h5v5h-5zM12 9l3-1",
  teach: "M5 20h5M7.5 20v-5l4-5 4 2M11.5 10l-1-4M17 14l1.5 5 1-2 2-.5z",
  time: "M12 4a8 8 0 1 1 0 16 8 8 0 0 1 0-16zM12 8v4.5l3 2",
  count: "M5 5v14M9 5v14M13 5v14M17 5v14M3 15 20 9",
  repeat: "M5 12V9a3 3 0 0 1 3-3h10m-3-3 3 3-3 3M19 12v3a3 3 0 0 1-3 3H6m3 3-3-3 3-3",
  task: "M4 6h4v4H4zM4 14h4v4H4zM11 8h9M11 16h9",
  state: "M5 5h14v14H5z",
};

const kOfCategories: Readonly<Record<Category, string>> = { motion: "move", gripper: "close", vision: "camera", people: "say", flow: "time" };

/** Of a name that is not known: that of the category. */
export function iconPath(name: string | undefined, category: Category | undefined): string {
  const own = name !== undefined && Object.hasOwn(kIcons, name) ? kIcons[name] : undefined;
  return own ?? kIcons[category === undefined ? "state" : kOfCategories[category]] ?? "";
}

export const kIconNames: readonly string[] = Object.keys(kIcons);
