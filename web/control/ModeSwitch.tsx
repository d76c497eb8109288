// The mode of the cell. A change stops what moves: with runs that have reserved services it is asked about first.
import { useState } from "react";
import type { CellMode } from "../generated/messages";
import { setMode } from "../shared/control/requests";
import { kModeMeans, modeName } from "../shared/control/texts";
import { byHand, reservedBy } from "../shared/stop/leases";
import { stop } from "../stop/page";
import { useStop } from "../stop/useStop";
import { texts } from "./texts";

const kModes: readonly CellMode[] = ["execution", "programming"];

interface Props {
  /** Why this person does not change it. */
  readonly refusal: string | undefined;
  /** Which tells who has the controls. */
  readonly fetcher: typeof fetch;
  /** What was in the way. */
  readonly onProblem: (error: unknown) => void;
}

export function ModeSwitch({ refusal, fetcher, onProblem }: Props) {
  const mode = useStop((now) => now.mode);
  const leases = useStop((now) => now.leases);
  const [asked, setAsked] = useState<CellMode>();
  const runs = reservedBy(leases).filter((each) => !byHand(each));
  const turn = (to: CellMode) => {
    setAsked(undefined);
    setMode(fetcher, to).then(stop.take, onProblem);
  };
  const wanted = refusal === undefined && asked !== mode && runs.length > 0 ? asked : undefined;
  return (
    <div className="mode-switch" role="group" aria-label={texts.mode.name}>
      {kModes.map((each) => (
        <button key={each} type="button" aria-pressed={mode === each} disabled={refusal !== undefined} title={refusal ?? kModeMeans[each]} onClick={() => mode !== each && (runs.length > 0 ? setAsked(each) : turn(each))}>
          {modeName(each)}
        </button>
      ))}
      {wanted !== undefined && (
        <div role="alertdialog" aria-label={texts.mode.question} aria-describedby="mode-question">
          <p id="mode-question">
            {texts.mode.paused(runs.map(({ core }) => core).join(", "), runs.length)}
          </p>
          <button type="button" autoFocus onClick={() => turn(wanted)}>
            {texts.mode.change(modeName(wanted))}
          </button>
          <button type="button" onClick={() => setAsked(undefined)}>
            {texts.mode.leave}
          </button>
        </div>
      )}
    </div>
  );
}
