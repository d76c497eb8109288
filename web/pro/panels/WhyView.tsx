// Why a port fired or not: the atoms of its condition with their values, and those whose change would fire it.
import type { Why } from "../../generated/messages";
import { atomAdvice, readsText, truthText, whyHeadline, whySentences } from "../../shared/run/whyText";
import { CodeText } from "./CodeText";

/** `when`: the moment that it is about, such as `now`. */
export function WhyView({ why, when }: { readonly why: Why; readonly when: string }) {
  return (
    <section className="why" aria-label="Why">
      <h3>{whyHeadline(why)}</h3>
      {whySentences(why).map((sentence) => (
        <p key={sentence}>
          <CodeText text={sentence} />
        </p>
      ))}
      <Atoms why={why} />
      <p className="quiet">
        Condition {when}: <strong>{truthText(why.value)}</strong>
      </p>
    </section>
  );
}

/** The atoms of the condition, in the order of its text. */
export function Atoms({ why }: { readonly why: Why }) {
  return (
    <ul aria-label="Atoms of the condition">
      {why.atoms.map((atom, i) => {
        const advice = atomAdvice(why, atom);
        const reads = readsText(atom);
        return (
          <li key={i} className={`atom is-${truthText(atom.value)}${advice === undefined ? "" : " blocks"}`} data-blocks={atom.blocks}>
            <code>{atom.text}</code>
            <span className="truth">{truthText(atom.value)}</span>
            {reads !== undefined && <small className="reads">{reads}</small>}
            {advice !== undefined && <small>{advice}</small>}
          </li>
        );
      })}
    </ul>
  );
}
