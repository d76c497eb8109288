// Why a port fired or not: the atoms of its condition with their values, and those whose change would fire it.
import type { Why } from "../../shared/messages/why";
import { truthText, whyHeadline } from "../../shared/run/whyText";

export function WhyView({ why }: { readonly why: Why }) {
  return (
    <section className="why" aria-label="Why">
      <h3>{whyHeadline(why)}</h3>
      <p>{why.reason}</p>
      <ul aria-label="Atoms of the condition">
        {why.atoms.map((atom, i) => (
          <li key={i} className={`atom is-${truthText(atom.value)}${atom.blocks ? " blocks" : ""}`} data-blocks={atom.blocks}>
            <code>{atom.text}</code>
            <span className="truth">{truthText(atom.value)}</span>
            {atom.blocks && <small>its change alone would fire this port</small>}
            {atom.requires.length > 0 && <small>reads {atom.requires.join(", ")}</small>}
          </li>
        ))}
      </ul>
      <p className="quiet">
        Condition now: <strong>{truthText(why.value)}</strong>
      </p>
    </section>
  );
}
