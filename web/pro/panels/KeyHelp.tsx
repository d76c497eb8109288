// All keys and mouse actions of the page, over it: opened with `?` or the button of the top bar, closed with Esc.
import { useModal } from "../../page/useModal";
import { gestures, shortcuts } from "../../shared/session/shortcuts";
import { actions } from "../edit/actions/registry";
import { useView, view } from "../client";

const close = () => view.dispatch({ type: "help", shown: false });

export function KeyHelp() {
  const shown = useView((v) => v.help);
  return shown ? <HelpDialog /> : null;
}

interface Keys {
  readonly keys: readonly string[];
  readonly does: string;
}

/** Those that the list above does not have. */
const editorKeys: readonly Keys[] = actions.filter(({ keys, where }) => keys.length > 0 && where !== "page").map(({ keys, name }) => ({ keys, does: name }));

function KeyList({ title, list }: { readonly title: string; readonly list: readonly Keys[] }) {
  return (
    <section aria-label={title}>
      <h3>{title}</h3>
      <dl>
        {list.map(({ keys, does }) => (
          <div key={does}>
            <dt>
              {keys.map((key) => (
                <kbd key={key}>{key}</kbd>
              ))}
            </dt>
            <dd>{does}</dd>
          </div>
        ))}
      </dl>
    </section>
  );
}

/** All keys and mouse actions. */
export function KeyLists() {
  return (
    <div className="help-lists">
      <KeyList title="Keys" list={shortcuts} />
      <KeyList title="Editor keys" list={editorKeys} />
      {gestures.map(({ where, list }) => (
        <section key={where} aria-label={where}>
          <h3>{where}</h3>
          <dl>
            {list.map(({ gesture, does }) => (
              <div key={gesture}>
                <dt>{gesture}</dt>
                <dd>{does}</dd>
              </div>
            ))}
          </dl>
        </section>
      ))}
    </div>
  );
}

function HelpDialog() {
  const dialog = useModal();
  return (
    <dialog ref={dialog} className="help" aria-label="Keys and mouse" onClose={close} onClick={(event) => event.target === event.currentTarget && close()}>
      <div className="help-body">
        <header>
          <h2>Keys and mouse</h2>
          <button type="button" aria-label="Close" onClick={close}>
            ✕
          </button>
        </header>
        <KeyLists />
      </div>
    </dialog>
  );
}
