// Under the drawing: where the document names an element, variable or service. Each line leads there; arrows go through them, Esc closes.
import { useDeferredValue, useMemo, type KeyboardEvent } from "react";
import { usagesOfReferent, type Referent } from "../../../shared/code/referent";
import { referentName, referentText, usageLine, type UsageLine } from "../../../shared/code/usageLines";
import type { Usage } from "../../../shared/code/usages";
import type { Tree } from "../../../shared/edit/tree";
import { useEditing } from "../editing";
import { goToField } from "../goToField";
import { closeUsages, kUsagesId, useShownUsages } from "./shown";

export function UsageList() {
  const document = useEditing((now) => now.document);
  const tree = useDeferredValue(useEditing((now) => now.session?.view));
  const referent = useShownUsages(document);
  if (referent === undefined || tree === undefined || !isThere(tree, referent)) return null;
  return <Listed tree={tree} referent={referent} />;
}

const isThere = (tree: Tree, referent: Referent): boolean => referent.kind === "service" || tree.elements.has(referent.kind === "element" ? referent.id : referent.state);

/** A field of an oracle is its expression or call. */
const fieldsOf = ({ field, span }: Usage, name: string): readonly string[] =>
  field === "oracle" && span !== undefined ? ["oracle:expr", "oracle:call"] : field === "services" ? [`service:${name}`] : [field];

/** The arrows go from line to line. */
function press(event: KeyboardEvent<HTMLElement>): void {
  const lines = [...event.currentTarget.querySelectorAll<HTMLElement>("li button")];
  const at = lines.findIndex((line) => line === document.activeElement);
  const next = { ArrowDown: lines[at + 1], ArrowUp: lines[at - 1], Home: lines[0], End: lines.at(-1) }[event.key];
  if (event.key === "Escape") closeUsages();
  else if (next !== undefined) next.focus();
  else return;
  event.preventDefault();
  event.stopPropagation();
}

function Listed({ tree, referent }: { readonly tree: Tree; readonly referent: Referent }) {
  const name = referentName(tree, referent);
  const lines = useMemo(() => usagesOfReferent(tree, referent).map((usage) => usageLine(tree, usage, name)), [tree, referent, name]);
  const title = `Usages of ${referentText(tree, referent)}`;
  return (
    <section id={kUsagesId} className="usage-list" aria-label={title} onKeyDown={press}>
      <header>
        <h3>
          {title} <small>{lines.length === 0 ? "none" : lines.length}</small>
        </h3>
        <button type="button" className="usage-close" aria-label="Close the usages" title="Close (Esc)" onClick={closeUsages}>
          ✕
        </button>
      </header>
      {lines.length === 0 && <p className="quiet pad">Nothing in the document names it.</p>}
      <ul>
        {lines.map((line, i) => (
          <li key={i}>
            <Line line={line} name={name} />
          </li>
        ))}
      </ul>
    </section>
  );
}

function Line({ line: { usage, place, before, name, after }, name: of }: { readonly line: UsageLine; readonly name: string }) {
  return (
    <button type="button" onClick={() => goToField(usage.id, fieldsOf(usage, of), usage.span)}>
      <span>{place}</span>
      <code>
        {before}
        <b>{name}</b>
        {after}
      </code>
    </button>
  );
}
