// What of a kind no test has come to: each row leads to its state or port.
import type { Gap, GapKind } from "../../shared/coverage/coverage";
import { kGapNames } from "../../shared/coverage/texts";
import { selectById } from "../edit/forms/selectById";

/** So many are listed. */
const kMost = 200;

export function GapList({ kind, gaps }: { readonly kind: GapKind; readonly gaps: readonly Gap[] }) {
  if (gaps.length === 0) return null;
  return (
    <section className="coverage-gaps" aria-label={kGapNames[kind]}>
      <h3>
        {kGapNames[kind]} <small>{gaps.length}</small>
      </h3>
      <ul aria-label={kGapNames[kind]}>
        {gaps.slice(0, kMost).map(({ text, id }) => (
          <li key={text}>
            {id === undefined ? (
              <span className="quiet">
                <code>{text}</code> (not in this document)
              </span>
            ) : (
              <button type="button" onClick={() => selectById(id)}>
                <code>{text}</code>
              </button>
            )}
          </li>
        ))}
        {gaps.length > kMost && <li className="quiet">{gaps.length - kMost} more</li>}
      </ul>
    </section>
  );
}
