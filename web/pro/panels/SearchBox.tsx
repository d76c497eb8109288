// Search over the model, with a jump to each hit; the arrows go through the hits.
import { useMemo, useState, type KeyboardEvent } from "react";
import type { ModelTree } from "../../shared/model/modelTree";
import { search, type Hit } from "../../shared/model/search";
import { view } from "../client";
import { unfold } from "../layout/panels";

const kId = "search";

export function focusSearch(): void {
  unfold("left");
  document.getElementById(kId)?.focus();
}

/** From the field down through the hits, and up again; Esc leads from a hit back to the field. */
function moveByArrow(event: KeyboardEvent<HTMLElement>): void {
  const stops = [...event.currentTarget.querySelectorAll<HTMLElement>("input, .hits button")];
  const at = stops.findIndex((stop) => stop === event.target);
  const next = { ArrowDown: stops[at + 1], ArrowUp: stops[at - 1], Escape: at > 0 ? stops[0] : undefined }[event.key];
  if (next === undefined) return;
  event.preventDefault();
  event.stopPropagation();
  next.focus();
}

function jump(hit: Hit): void {
  const selection = hit.kind === "node" ? ({ kind: "node", path: hit.target } as const) : ({ kind: "port", address: hit.target } as const);
  view.dispatch({ type: "jump", selection });
}

export function SearchBox({ tree }: { readonly tree: ModelTree | undefined }) {
  const [query, setQuery] = useState("");
  const hits = useMemo(() => (tree === undefined ? [] : search(tree, query)), [tree, query]);
  return (
    <section className="search" onKeyDown={moveByArrow}>
      <input
        id={kId}
        type="search"
        placeholder="Search states, ports, code"
        aria-label="Search the model"
        value={query}
        onChange={(event) => setQuery(event.target.value)}
        onKeyDown={(event) => {
          const first = hits[0];
          if (event.key === "Enter" && first !== undefined) jump(first);
          if (event.key === "Escape") setQuery("");
        }}
      />
      {query !== "" && (
        <ul className="hits" aria-label="Search results">
          {hits.map((hit) => (
            <li key={hit.target}>
              <button type="button" onClick={() => jump(hit)}>
                <span className={`mark mark-${hit.kind}`} aria-hidden="true" />
                <span className="hit-text">
                  {hit.target}
                  {hit.context !== undefined && <code>{hit.context}</code>}
                </span>
              </button>
            </li>
          ))}
          {hits.length === 0 && <li className="quiet">Nothing found</li>}
        </ul>
      )}
    </section>
  );
}
