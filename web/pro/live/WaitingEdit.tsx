// An edit of the document that the run has not got, above the run bar, with what it waits for, or what is wrong with it.
import type { EditText } from "../../shared/run/edits";
import { editText } from "../../shared/run/edits";
import { api, attempt, useCore, useView, view } from "../client";
import { useRefusal } from "../login/rights";
import { CodeText } from "../panels/CodeText";
import { Icon } from "../panels/Icon";
import { goToError } from "../edit/errors";
import { useEditing } from "../edit/editing";
import { inEdited, inRun, showInRun } from "./turnTo";
import { useRunTree } from "./runTree";

type Obstacle = EditText["waits"][number];

/** Shows what it is about: in the document, if that is edited and has it, else in the run. Nothing: neither has it. */
function wayTo({ path, id, error }: Obstacle, isEdited: boolean): (() => void) | undefined {
  const edited = isEdited ? inEdited(id) : undefined;
  if (isEdited && error !== undefined) return () => goToError(error);
  if (edited !== undefined) return () => view.dispatch({ type: "jump", selection: edited });
  const selection = inRun(path);
  return selection && (() => showInRun(selection));
}

function Line({ obstacle, isEdited }: { readonly obstacle: Obstacle; readonly isEdited: boolean }) {
  const go = wayTo(obstacle, isEdited);
  if (go === undefined) return <CodeText text={obstacle.text} />;
  return (
    <button type="button" className="link" onClick={go}>
      <CodeText text={obstacle.text} />
    </button>
  );
}

/** Only who has the controls confirms an edit: for others, why not. */
function Confirm({ core, revision }: { readonly core: string; readonly revision: number }) {
  const refusal = useRefusal("confirm_edit");
  return (
    <>
      {refusal !== undefined && <small>Confirm: {refusal}.</small>}
      <button type="button" className="confirm-edit" disabled={refusal !== undefined} title={refusal ?? "The run gets this edit as soon as it can"} onClick={() => void attempt(async () => void (await api.confirmEdit(core, revision)))}>
        Confirm revision {revision}
      </button>
    </>
  );
}

export function WaitingEdit() {
  const core = useCore();
  const page = useView((v) => v.page);
  // The links are made anew with the models that they lead to.
  useRunTree();
  const document = useEditing((now) => (now.session?.view === undefined ? undefined : now.document));
  const text = core === undefined ? undefined : editText(core);
  if (text === undefined) return null;
  const isEdited = page === "edit" && document === core?.document;
  return (
    <div className="interruption" role="status" aria-label="Waiting edit">
      <Icon name="interrupted" />
      <div>
        <strong>{text.title}</strong>
        {text.waits.length > 0 && (
          <ul>
            {text.waits.map((obstacle, i) => (
              <li key={i}>
                <Line obstacle={obstacle} isEdited={isEdited} />
              </li>
            ))}
          </ul>
        )}
        <p>{text.holds}</p>
      </div>
      {core !== undefined && text.confirms !== undefined && <Confirm core={core.id} revision={text.confirms} />}
    </div>
  );
}
