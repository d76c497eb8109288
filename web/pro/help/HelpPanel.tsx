// The help, over the page: opened with F1, closed with Esc. Topics left, the chosen one right.
import { useEffect, useMemo, useRef, useState, type KeyboardEvent } from "react";
import { findTopics, groupedTopics, topicOf } from "../../shared/help/topics";
import { useRefusal } from "../login/rights";
import { Blocks } from "./Blocks";
import { showHelp, useHelp, type HelpPlace } from "./help";
import { startTour } from "./tour";

export function HelpPanel() {
  const place = useHelp();
  return place === undefined ? null : <Panel place={place} />;
}

const close = () => showHelp(undefined);

/** From the search down through the topics, and up again. */
function moveByArrow(event: KeyboardEvent<HTMLElement>): void {
  const by = event.key === "ArrowDown" ? 1 : event.key === "ArrowUp" ? -1 : 0;
  const stops = [...event.currentTarget.querySelectorAll<HTMLElement>("input[type=search], .help-topic")];
  const at = stops.findIndex((stop) => stop === event.target);
  if (by === 0 || at < 0) return;
  event.preventDefault();
  stops[at + by]?.focus();
}

function Panel({ place }: { readonly place: HelpPlace }) {
  const dialog = useRef<HTMLDialogElement>(null);
  const search = useRef<HTMLInputElement>(null);
  const article = useRef<HTMLElement>(null);
  const [query, setQuery] = useState("");
  const found = useMemo(() => findTopics(query), [query]);
  const topic = topicOf(place.topic);
  const refusal = useRefusal("store_document");
  useEffect(() => {
    dialog.current?.showModal();
    search.current?.focus();
  }, []);
  useEffect(() => {
    const term = place.term === undefined ? null : document.getElementById(place.term);
    if (term === null) article.current?.scrollTo(0, 0);
    else term.scrollIntoView({ block: "center" });
  }, [place]);
  return (
    <dialog ref={dialog} className="guide" aria-label="Help" onClose={close} onClick={(event) => event.target === event.currentTarget && close()}>
      <div className="guide-body">
        <nav aria-label="Topics" onKeyDown={moveByArrow}>
          <input ref={search} type="search" placeholder="Search the help" aria-label="Search the help" value={query} onChange={(event) => setQuery(event.target.value)} onKeyDown={(event) => event.key === "Enter" && found[0] !== undefined && showHelp({ topic: found[0].id })} />
          {groupedTopics(found).map(({ group, topics }) => (
            <div key={group} role="group" aria-label={group}>
              <h3>{group}</h3>
              <ul>
                {topics.map(({ id, title }) => (
                  <li key={id}>
                    <button type="button" className="help-topic" aria-current={id === place.topic ? "page" : undefined} onClick={() => showHelp({ topic: id })}>
                      {title}
                    </button>
                  </li>
                ))}
              </ul>
            </div>
          ))}
          {found.length === 0 && <p className="quiet">Nothing is found.</p>}
        </nav>
        <article ref={article} aria-label={topic?.title} tabIndex={-1}>
          <button type="button" className="guide-close" aria-label="Close" onClick={close}>
            ✕
          </button>
          {topic !== undefined && (
            <>
              <h2>{topic.title}</h2>
              <Blocks blocks={topic.blocks} marked={place.term} />
              {topic.id === "start" && (
                <button type="button" className="lead" disabled={refusal !== undefined} title={refusal} onClick={startTour}>
                  Start the tour
                </button>
              )}
            </>
          )}
        </article>
      </div>
    </dialog>
  );
}
