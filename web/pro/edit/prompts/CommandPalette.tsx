// All commands by name: some letters of it, Enter. What cannot be done now is listed, too, with its reason.
import { useEffect, useMemo, useRef, useState, type KeyboardEvent } from "react";
import { fuzzyFilter } from "../../../shared/edit/fuzzy";
import { actions } from "../actions/registry";
import { reasonAgainst, runAction, type Action } from "../actions/action";
import { endPrompt } from "../prompt";
import { situationNow } from "../situation";

const kList = "palette-list";
const optionId = (index: number) => `palette-${index}`;

export function CommandPalette() {
  const dialog = useRef<HTMLDialogElement>(null);
  const [query, setQuery] = useState("");
  const [at, setAt] = useState(0);
  const situation = useMemo(() => situationNow(), []);
  const found = useMemo(() => fuzzyFilter(query, actions, ({ name, group }) => `${name} ${group}`), [query]);
  useEffect(() => dialog.current?.showModal(), []);
  useEffect(() => {
    document.getElementById(optionId(at))?.scrollIntoView({ block: "nearest" });
  }, [at, found]);
  const choose = (action: Action | undefined) => {
    if (action === undefined || reasonAgainst(action, situation) !== undefined) return;
    endPrompt();
    runAction(action);
  };
  const press = (event: KeyboardEvent) => {
    event.stopPropagation();
    const last = found.length - 1;
    if (event.key === "ArrowDown") setAt(Math.min(last, at + 1));
    else if (event.key === "ArrowUp") setAt(Math.max(0, at - 1));
    else if (event.key === "Enter") choose(found[at]);
    else if (event.key === "Escape") endPrompt();
    else return;
    event.preventDefault();
  };
  return (
    <dialog ref={dialog} className="palette-dialog" aria-label="Commands" onClose={endPrompt} onClick={(event) => event.target === event.currentTarget && endPrompt()} onKeyDown={press}>
      <input
        role="combobox"
        aria-label="Command"
        aria-expanded="true"
        aria-controls={kList}
        aria-activedescendant={found[at] === undefined ? undefined : optionId(at)}
        placeholder="Some letters of a command"
        autoFocus
        autoComplete="off"
        value={query}
        onChange={(event) => {
          setQuery(event.target.value);
          setAt(0);
        }}
      />
      <ul id={kList} role="listbox" aria-label="Commands">
        {found.map((action, i) => {
          const reason = reasonAgainst(action, situation);
          return (
            <li key={action.id} id={optionId(i)} role="option" aria-selected={i === at} aria-disabled={reason !== undefined} onClick={() => choose(action)} onPointerMove={() => setAt(i)}>
              <span>{action.name}</span>
              {action.keys[0] !== undefined && <kbd>{action.keys[0]}</kbd>}
              <small>{reason ?? action.group}</small>
            </li>
          );
        })}
      </ul>
      {found.length === 0 && <p className="quiet pad">No command has these letters.</p>}
    </dialog>
  );
}
