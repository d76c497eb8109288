// An edit of the document that the run has not got, above the run bar, with what it waits for.
import { editText } from "../../shared/run/edits";
import type { ModelTree } from "../../shared/model/modelTree";
import { selectionAt } from "../../shared/session/view";
import { useCore, view } from "../client";
import { CodeText } from "./CodeText";
import { Icon } from "./Icon";

/** A place is a link if the model of the run has it: an edit may be about elements of its own. */
function Obstacle({ tree, path, text }: { readonly tree: ModelTree | undefined; readonly path: string; readonly text: string }) {
  const selection = tree && selectionAt(tree, path);
  if (selection === undefined) return <CodeText text={text} />;
  return (
    <button type="button" className="link" onClick={() => view.dispatch({ type: "jump", selection })}>
      <CodeText text={text} />
    </button>
  );
}

export function WaitingEdit({ tree }: { readonly tree: ModelTree | undefined }) {
  const core = useCore();
  const text = core === undefined ? undefined : editText(core);
  if (text === undefined) return null;
  return (
    <div className="interruption" role="status" aria-label="Waiting edit">
      <Icon name="interrupted" />
      <div>
        <strong>{text.title}</strong>
        {text.waits.length > 0 && (
          <ul>
            {text.waits.map(({ path, text: why }, i) => (
              <li key={i}>
                <Obstacle tree={tree} path={path} text={why} />
              </li>
            ))}
          </ul>
        )}
        <p>{text.holds}</p>
      </div>
    </div>
  );
}
