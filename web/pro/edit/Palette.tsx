// What can be added: dragged onto the drawing, or by Enter to where the selection is.
import { addBarrier, addPort, addState } from "../../shared/edit/commands/add";
import { placeIn } from "../../shared/edit/commands/place";
import { useRefusal } from "../login/rights";
import { runAction } from "./actions/action";
import { newId } from "../../shared/newId";
import { actionOf } from "./actions/registry";
import { followPointer } from "./gestures/drag";
import { dropNew, type NewThing } from "./gestures/dropNew";

interface Item extends NewThing {
  /** What Enter and a click do. */
  readonly action: string;
}

const items: readonly Item[] = [
  { name: "State", onto: "composite", action: "add_state", make: (tree, parent) => addState(tree, placeIn(tree, parent), newId) },
  { name: "Barrier", onto: "composite", action: "add_barrier", make: (tree, parent) => addBarrier(tree, placeIn(tree, parent), newId) },
  { name: "Port", onto: "state", action: "add_port", make: (tree, parent) => addPort(tree, parent, newId) },
];

export function Palette() {
  const refusal = useRefusal("edit");
  return (
    <section className="palette" aria-label="Add">
      <h2>Add</h2>
      <ul>
        {items.map((item) => (
          <li key={item.name}>
            <button
              type="button"
              className="palette-item"
              disabled={refusal !== undefined}
              title={refusal ?? `Drag onto the drawing, or press Enter (${actionOf(item.action).keys.join(" or ")})`}
              onPointerDown={(event) => event.button === 0 && followPointer(event, () => dropNew(item))}
              onClick={() => runAction(actionOf(item.action))}
            >
              {item.name}
            </button>
          </li>
        ))}
      </ul>
    </section>
  );
}
