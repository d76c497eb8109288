// Several nodes are selected: how many, and what can be done with all of them.
import { runAction } from "../actions/action";
import { actionOf } from "../actions/registry";

/** The actions of the page on what is selected; each asks for what it needs, or says why it cannot be done. */
const kActions: readonly { readonly id: string; readonly name: string }[] = [
  { id: "group", name: "Group" },
  { id: "duplicate", name: "Duplicate" },
  { id: "delete", name: "Delete" },
];

export function SeveralForm({ paths }: { readonly paths: readonly string[] }) {
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
        {kActions.map(({ id, name }) => (
          <button key={id} type="button" onClick={() => runAction(actionOf(id))}>
            {name}
          </button>
        ))}
      </div>
    </div>
  );
}
