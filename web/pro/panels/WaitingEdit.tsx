// An edit of the document that the run has not got, above the run bar, with what it waits for.
import { editText } from "../../shared/run/edits";
import { useCore, useSession, view } from "../client";
import { Icon } from "./Icon";

export function WaitingEdit() {
  const core = useCore();
  const known = useSession((s) => s.model);
  const text = core === undefined ? undefined : editText(core);
  if (text === undefined) return null;
  return (
    <div className="interruption" role="status" aria-label="Waiting edit">
      <Icon name="interrupted" />
      <div>
        <strong>{text.title}</strong>
        {text.waits.length > 0 && (
          <ul>
            {text.waits.map(({ path, text: why }) => (
              <li key={why}>
                {known === undefined || path === "" ? (
                  why
                ) : (
                  <button type="button" className="link" onClick={() => view.dispatch({ type: "jump", selection: { kind: "node", path } })}>
                    {why}
                  </button>
                )}
              </li>
            ))}
          </ul>
        )}
        <p>{text.holds}</p>
      </div>
    </div>
  );
}
