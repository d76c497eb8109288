// Several nodes are selected: how many, and what can be done with all of them.
import { idAt } from "../../../shared/model/identity";
import type { ModelTree } from "../../../shared/model/modelTree";
import { freeNameIn } from "../../../shared/edit/commands/command";
import { elementOf } from "../../../shared/edit/tree";
import { editedDocument, perform } from "../editing";

const group = (ids: readonly string[]): void => {
  const tree = editedDocument();
  const [first] = ids;
  if (tree === undefined || first === undefined) return;
  perform({ compound: { kind: "group", ids, name: freeNameIn(tree, elementOf(tree, first).parent, "children", "Group") } });
};

export function SeveralForm({ tree, paths }: { readonly tree: ModelTree; readonly paths: readonly string[] }) {
  const ids = paths.flatMap((path) => idAt(tree, { kind: "node", path }) ?? []);
  return (
    <div className="form">
      <header className="form-head">
        <small>Selected</small>
        <h2>{paths.length} nodes</h2>
      </header>
      <ul className="form-list">
        {paths.map((path) => (
          <li key={path}>{path}</li>
        ))}
      </ul>
      <div className="form-tools">
        <button type="button" onClick={() => group(ids)}>
          Group
        </button>
        <button type="button" onClick={() => ids.forEach((id) => perform({ compound: { kind: "duplicate", id } }))}>
          Duplicate
        </button>
        <button type="button" onClick={() => perform({ operations: ids.map((id) => ({ op: "remove", id })) })}>
          Delete
        </button>
      </div>
    </div>
  );
}
