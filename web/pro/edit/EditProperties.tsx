// Right of the document that is edited: the form of what is selected. Nothing selected: the state of the library that is shown, else the document.
import type { KeyboardEvent } from "react";
import type { ModelTree } from "../../shared/model/modelTree";
import { barrierAt, portAt, stateAt } from "../../shared/model/modelTree";
import { selectedPaths, type Selection } from "../../shared/session/view";
import { useView } from "../client";
import { useEditing } from "./editing";
import { BarrierForm } from "./forms/BarrierForm";
import { DocumentForm } from "./forms/DocumentForm";
import { keepKeys, leaveByEscape } from "./forms/keepKeys";
import { PortForm } from "./forms/PortForm";
import { SeveralForm } from "./forms/SeveralForm";
import { StateForm } from "./forms/StateForm";
import { useAuthors } from "./forms/useAuthors";

export function EditProperties({ tree }: { readonly tree: ModelTree | undefined }) {
  const selection = useView((v) => v.selection);
  const also = useView((v) => v.also);
  const top = useEditing((now) => now.top);
  useAuthors();
  return (
    <aside className="side side-right" aria-label="Properties" onKeyDown={pressed}>
      {tree !== undefined && selection !== undefined && also.size > 0 ? (
        <SeveralForm paths={selectedPaths({ selection, also })} />
      ) : (
        <One tree={tree} selection={selection} top={top} />
      )}
    </aside>
  );
}

function pressed(event: KeyboardEvent): void {
  keepKeys(event);
  leaveByEscape(event);
}

interface Props {
  readonly tree: ModelTree | undefined;
  readonly selection: Selection | undefined;
  readonly top: string | undefined;
}

function One({ tree, selection, top }: Props) {
  if (tree === undefined) return null;
  if (selection?.kind === "port") {
    const port = portAt(tree, selection.address);
    if (port?.id !== undefined) return <PortForm key={port.id} id={port.id} />;
  }
  const [root] = tree.keys();
  const path = selection?.kind === "node" ? selection.path : top === undefined ? undefined : root;
  if (path === undefined) return <DocumentForm />;
  const [state, barrier] = [stateAt(tree, path), barrierAt(tree, path)];
  if (state !== undefined) return <StateForm key={state.id} state={state} />;
  return barrier === undefined ? <DocumentForm /> : <BarrierForm key={barrier.id} barrier={barrier} />;
}
