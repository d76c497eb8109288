// One inference as the thesis prints it: premises above the bar, conclusion below, the rule's name beside it.
import { facts, judgement, premiseCount } from "../../shared/derivation/proof";
import type { Derivation } from "../../generated/messages";
import { useSession, view } from "../client";

export function InferenceCard({ node }: { readonly node: Derivation }) {
  const text = useSession((s) => s.rules.get(node.rule));
  return (
    <section className="inference" aria-label="Inference">
      <header>
        <h3>
          {node.rule} <span className="equation">({node.equation})</span>
        </h3>
        {text !== undefined && <small>{text.layer}</small>}
      </header>
      {text !== undefined && <p className="rule-text">{text.text}</p>}
      <figure className="rule-figure" tabIndex={0} aria-label={`${node.rule}: ${premiseCount(node)}`}>
        <ul className="premises">
          {node.premises.map((premise, i) => (
            <li key={i}>
              {judgement(premise)} <small>{premise.rule}</small>
            </li>
          ))}
          {node.premises.length === 0 && <li className="quiet">no premises</li>}
        </ul>
        <hr />
        <figcaption>{judgement(node)}</figcaption>
      </figure>
      <dl className="pairs">
        {facts(node).map((fact) => (
          <div key={fact.name}>
            <dt>{fact.name}</dt>
            <dd>
              <code>{fact.text}</code>
            </dd>
          </div>
        ))}
      </dl>
      <button type="button" className="link" onClick={() => view.dispatch({ type: "jump", selection: { kind: "node", path: node.at } })}>
        Show {node.at} in the model
      </button>
    </section>
  );
}
