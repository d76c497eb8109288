// What went wrong in this run and is put right: a line each, the latest first.
import type { PastFailure } from "../../shared/timeline/failures";
import { texts } from "../texts";

const t = texts.runView;
/** So many lines are shown. */
const kLines = 8;

export function Past({ past }: { readonly past: readonly PastFailure[] }) {
  if (past.length === 0) return null;
  const earlier = past.slice(0, -kLines).reduce((sum, { times }) => sum + times, 0);
  return (
    <section className="past" aria-label={t.past}>
      <h2>{t.past}</h2>
      <ol>
        {past.slice(-kLines).reverse().map(({ failure, became, times }, i) => (
          <li key={`${past.length - i}`}>
            {t.pastFailure(failure.step.title, failure.title, times)} {t.became[became]}
          </li>
        ))}
      </ol>
      {earlier > 0 && <p>{t.earlier(earlier)}</p>}
    </section>
  );
}
