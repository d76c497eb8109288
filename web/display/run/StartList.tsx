// The tasks that can be started.
import { starters } from "../../shared/documents/starters";
import { errorCount } from "../../shared/session/draft";
import { wordsOf } from "../../shared/pendant/activity";
import { isOwn } from "../../shared/control/texts";
import { useIsMaking } from "../../page/starting";
import { useStop } from "../../stop/useStop";
import { useRefusalToStart, useSession } from "../client";
import { texts } from "../texts";
import { startDocument } from "./runs";
import { supervise, useSupervised } from "../../control/supervised";

export function StartList() {
  const documents = useSession((now) => now.documents);
  const refusal = useRefusalToStart();
  const starting = useIsMaking();
  const shown = starters(documents, documents.length).filter((each) => errorCount(each) === 0);
  return (
    <section aria-label={texts.start.title}>
      <h2>{texts.start.title}</h2>
      <SupervisedBox />
      {refusal !== undefined && <p className="soft">{texts.start.refused(refusal)}</p>}
      {shown.length === 0 && <p className="empty">{texts.start.none}</p>}
      <ul className="runs">
        {shown.map(({ name, doc }) => (
          <li key={name}>
            <button type="button" className="plain" aria-label={texts.start.start(name)} disabled={starting || refusal !== undefined} title={refusal} onClick={() => startDocument(name)}>
              <b>{wordsOf(name)}</b> {doc !== undefined && <small>{doc}</small>}
            </button>
          </li>
        ))}
      </ul>
    </section>
  );
}

function SupervisedBox() {
  const on = useSupervised();
  const isMine = useStop((stop) => isOwn(stop.holder, stop.held));
  const isAlways = useStop((stop) => stop.mode === "programming");
  return (
    <label className="box">
      <input type="checkbox" checked={isMine && (on || isAlways)} disabled={!isMine || isAlways} onChange={(event) => supervise(event.target.checked)} />
      <span>{isMine ? texts.start.supervised : texts.start.supervisedLater}</span>
    </label>
  );
}
