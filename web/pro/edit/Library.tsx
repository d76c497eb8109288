// The states of the library: each is shown as a whole, linked by drag or Enter, renamed, deleted.
import { addLink } from "../../shared/edit/commands/add";
import { nameOfElement } from "../../shared/edit/commands/command";
import { placeIn } from "../../shared/edit/commands/place";
import { linksTo, remove } from "../../shared/edit/commands/remove";
import type { Tree } from "../../shared/edit/tree";
import { refusalNow, useRefusal } from "../login/rights";
import { runAction } from "./actions/action";
import { placeFor } from "./actions/addActions";
import { newId } from "../../shared/newId";
import { askName } from "./actions/nameActions";
import { actionOf } from "./actions/registry";
import { carryOut } from "./carryOut";
import { editedDocument, showTop, useEditing } from "./editing";
import { followPointer } from "./gestures/drag";
import { dropNew, type NewThing } from "./gestures/dropNew";
import { ask, type MenuEntry } from "./prompt";
import { situationNow } from "./situation";
import { counted } from "../../shared/counted";

export function Library() {
  const tree = useEditing((now) => now.session?.view);
  const top = useEditing((now) => now.top);
  const refusal = useRefusal("edit");
  if (tree === undefined) return null;
  return (
    <section className="library" aria-label="Library">
      <header>
        <h2>Library</h2>
        <button type="button" aria-label="New library state" disabled={refusal !== undefined} title={refusal ?? "New library state"} onClick={() => runAction(actionOf("add_library_state"))}>
          +
        </button>
      </header>
      <ul>
        {tree.library.map((id) => (
          <Row key={id} tree={tree} id={id} shown={id === top} />
        ))}
      </ul>
      {tree.library.length === 0 && <p className="quiet">No library states yet.</p>}
    </section>
  );
}

const linkTo = (tree: Tree, id: string): NewThing => ({ name: nameOfElement(tree, id), onto: "composite", make: (now, parent) => addLink(now, placeIn(now, parent), id, newId) });

/** A link where something new would go. */
function linkHere(id: string): void {
  const situation = situationNow();
  if (situation !== undefined) carryOut(addLink(situation.tree, placeFor(situation), id, newId));
}

/** What can be done with a state of the library. */
function entriesFor(tree: Tree, id: string): readonly MenuEntry[] {
  const removal = remove(tree, [id]);
  const reason = refusalNow("edit");
  const rename = (): void => {
    const situation = situationNow();
    if (situation !== undefined) askName(situation, id, document.querySelector(`[data-library="${CSS.escape(id)}"]`)?.getBoundingClientRect());
  };
  const removeNow = (): void => {
    const now = editedDocument();
    if (now !== undefined) carryOut(remove(now, [id]));
  };
  return [
    { name: "Link here", reason, run: () => linkHere(id) },
    { name: "Open", run: () => showTop(id) },
    { name: "Rename", reason, run: rename },
    { name: "Delete", reason: reason ?? ("reason" in removal ? removal.reason : undefined), run: removeNow },
  ];
}

function Row({ tree, id, shown }: { readonly tree: Tree; readonly id: string; readonly shown: boolean }) {
  const name = nameOfElement(tree, id);
  const uses = linksTo(tree, id).length;
  return (
    <li data-library={id}>
      <button
        type="button"
        className="palette-item"
        aria-current={shown ? "page" : undefined}
        title="Drag onto the drawing to link it; click to open it"
        onPointerDown={(event) => event.button === 0 && followPointer(event, () => (refusalNow("edit") === undefined ? dropNew(linkTo(tree, id)) : undefined))}
        onClick={() => showTop(id)}
      >
        {name} <small>{uses === 0 ? "not used" : counted(uses, "link")}</small>
      </button>
      <button
        type="button"
        className="library-more"
        aria-label={`Actions of ${name}`}
        aria-haspopup="menu"
        onClick={(event) => {
          const { left, bottom } = event.currentTarget.getBoundingClientRect();
          ask({ kind: "menu", label: `Actions of ${name}`, at: { x: left, y: bottom }, entries: entriesFor(tree, id) });
        }}
      >
        ⋯
      </button>
    </li>
  );
}
