// The state editor (thesis, Fig. A.2): interface, functions and ports of the selected state, or of the state of the selected port. The rest of
// the page stays in use; Esc closes it.
import { useEffect } from "react";
import { stateAt, type ModelTree } from "../../../shared/model/modelTree";
import { pathOf } from "../../../shared/session/view";
import { useView } from "../../client";
import { canvasElement } from "../gestures/onScreen";
import { DataRows } from "./DataRows";
import { keepKeys } from "./keepKeys";
import { PortRows } from "./PortFields";
import { Functions } from "./StateForm";
import { closeStateEditor, useStateEditor } from "./stateEditor";

export function StateEditor({ tree }: { readonly tree: ModelTree | undefined }) {
  const isOpen = useStateEditor();
  const selection = useView((v) => v.selection);
  const path = selection === undefined ? undefined : pathOf(selection);
  const state = path === undefined ? undefined : tree && stateAt(tree, path);
  const isShown = isOpen && state !== undefined;
  useEffect(() => {
    if (!isShown) return;
    // Before the keys of the page, behind those of a field with a draft.
    const press = (event: KeyboardEvent) => {
      if (event.key !== "Escape" || event.defaultPrevented) return;
      event.stopPropagation();
      closeStateEditor();
      canvasElement()?.focus({ preventScroll: true });
    };
    document.addEventListener("keydown", press);
    return () => document.removeEventListener("keydown", press);
  }, [isShown]);
  if (!isShown) return null;
  return (
    <section className="state-editor" aria-label={`State editor: ${state.name}`} onKeyDown={keepKeys}>
      <header>
        <h2>{state.name}</h2>
        <span className="quiet">{path}</span>
        <button type="button" aria-label="Close the state editor" title="Close (Esc)" onClick={closeStateEditor}>
          ✕
        </button>
      </header>
      <div className="state-editor-columns" key={state.id}>
        <div className="form">
          <DataRows state={state} />
        </div>
        <div className="form">
          <Functions state={state} />
        </div>
        <div className="form">
          <PortRows state={state} />
        </div>
      </div>
    </section>
  );
}
