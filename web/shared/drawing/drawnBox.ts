// Where elements of a model are in its drawing.
import type { Selection } from "../model/identity";
import { splitAddress } from "../model/modelTree";
import type { Box, Drawing } from "./drawing";

/** Of a node or port; nothing: it is not drawn. */
export function drawnBox({ nodes }: Drawing, selection: Selection): Box | undefined {
  const path = selection.kind === "node" ? selection.path : splitAddress(selection.address)?.path;
  const node = nodes.find((each) => each.path === path);
  return selection.kind === "node" ? node : node?.ports.find(({ address }) => address === selection.address);
}

/** The same; of what is not drawn, of the innermost node that is drawn and has it inside. */
export function shownBox(drawing: Drawing, selection: Selection): { readonly box: Box; readonly inside: boolean } | undefined {
  const box = drawnBox(drawing, selection);
  if (box !== undefined) return { box, inside: false };
  const address = selection.kind === "node" ? selection.path : (splitAddress(selection.address)?.path ?? "");
  for (let path = address; path !== ""; path = path.slice(0, Math.max(0, path.lastIndexOf("/")))) {
    const around = drawing.nodes.find((each) => each.path === path);
    if (around !== undefined) return { box: around, inside: true };
  }
  return undefined;
}
