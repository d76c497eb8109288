// The loops in which the run is: which round goes on, and how long rounds take.
import { durationText } from "../../shared/runs/texts";
import { texts } from "../texts";
import type { ShownRound } from "./rounds";

const t = texts.runView;

export function Rounds({ rounds }: { readonly rounds: readonly ShownRound[] }) {
  if (rounds.length === 0) return null;
  return (
    <ul className="rounds" aria-label={t.rounds}>
      {rounds.map(({ loop, number, of, times }) => (
        <li key={loop.id}>
          {rounds.length > 1 && <span>{loop.title}</span>}
          <b>{of === undefined ? t.round(number) : t.roundOf(number, of)}</b>
          {times?.last !== undefined && <span>{t.roundTimes(durationText(times.last), durationText(times.sum / times.count), times.count)}</span>}
        </li>
      ))}
    </ul>
  );
}
