// Dragging something new onto the drawing: it goes into the composite under the pointer.
import type { Command } from "../../../shared/edit/commands/command";
import type { Tree } from "../../../shared/edit/tree";
import { pathOf } from "../../../shared/session/view";
import { carryOut } from "../carryOut";
import type { ScreenPoint } from "../prompt";
import { situationNow, type Situation } from "../situation";
import type { Drag } from "./drag";
import { boxOf, hitAt, isOnDrawing } from "./onScreen";
import { showDrag } from "./shown";

export interface NewThing {
  readonly name: string;
  /** Whether it goes onto any state (a port), or only into one that has states inside, or the one that is shown. */
  readonly onto: "state" | "composite";
  readonly make: (tree: Tree, parent: string) => Command;
}

/** The state that it would go into: its id and path. */
function homeAt({ model, focus }: Situation, { onto }: NewThing, at: ScreenPoint): { readonly id: string; readonly path: string } | undefined {
  if (!isOnDrawing(at)) return undefined;
  const hit = hitAt(at);
  for (let path = hit === undefined ? undefined : pathOf(hit); path !== undefined; path = model.get(path)?.parent) {
    const entry = model.get(path);
    const fits = entry?.node.kind === "state" && (onto === "state" || entry.children.length > 0);
    if (fits && entry.node.id !== undefined) return { id: entry.node.id, path };
  }
  return focus;
}

export function dropNew(thing: NewThing): Drag {
  return {
    move: (at) => {
      const situation = situationNow();
      const home = situation && homeAt(situation, thing, at);
      const command = situation && home && thing.make(situation.tree, home.id);
      const reason = command !== undefined && "reason" in command ? command.reason : undefined;
      showDrag({ target: home && reason === undefined ? boxOf({ kind: "node", path: home.path }) : undefined, text: { at, text: reason ?? thing.name, refused: reason !== undefined } });
    },
    drop: (at) => {
      const situation = situationNow();
      const home = situation && homeAt(situation, thing, at);
      if (situation !== undefined && home !== undefined) carryOut(thing.make(situation.tree, home.id));
    },
    end: () => showDrag(undefined),
  };
}
