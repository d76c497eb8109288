// Dragging something new onto the drawing: it goes into the composite under the pointer.
import type { Command } from "../../../shared/edit/commands/command";
import { placeOf } from "../../../shared/edit/commands/placing";
import type { Tree } from "../../../shared/edit/tree";
import { selectionsOf } from "../../../shared/model/identity";
import { pathOf } from "../../../shared/session/view";
import { shownCanvas } from "../../canvas/canvasView";
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

/** The command, with the place where the new element was dropped, if it is one that has a place in its state. */
function placed(command: Command, thing: NewThing, home: { readonly id: string; readonly path: string }, at: ScreenPoint): Command {
  const canvas = shownCanvas();
  if (thing.onto !== "composite" || canvas === undefined || !("change" in command) || !("operations" in command.change) || command.select === undefined) return command;
  const drawn = selectionsOf(canvas.laid.tree).get(home.id);
  const place = drawn?.kind === "node" ? placeOf(canvas.laid.drawing, canvas.toModel(at), { path: drawn.path, id: home.id }) : undefined;
  if (place === undefined) return command;
  const set = { op: "set", id: "", field: "layout", key: command.select, value: { ...place } } as const;
  return { ...command, change: { operations: [...command.change.operations, set] } };
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
      if (situation !== undefined && home !== undefined) carryOut(placed(thing.make(situation.tree, home.id), thing, home, at));
    },
    end: () => showDrag(undefined),
  };
}
