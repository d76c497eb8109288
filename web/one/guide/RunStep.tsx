// The application is run, and its result is said.
import { statusLook } from "../../shared/run/controls";
import { useCore } from "../client";
import { go, usePlace } from "../place";
import { RunView } from "../run/RunView";
import { texts } from "../texts";
import { leaveGuide } from "./steps";
import { Ways } from "./Ways";

const t = texts.run;

export function RunStep() {
  const edit = usePlace((place) => place.edit);
  const core = useCore();
  const isDone = core !== undefined && statusLook(core) === "ended";
  return (
    <>
      {edit !== undefined ? <RunView name={edit} /> : <main className="guided-body"><p className="problem">{texts.application.missingPoses}</p></main>}
      <section className="guided-body is-below" aria-label={texts.guide.ways}>
        {isDone && (
          <>
            <p className="guided-done" role="status">
              {t.done} {t.again}
            </p>
            <button type="button" onClick={() => go({ guide: undefined, part: undefined, goal: undefined, view: "build" })}>
              {t.toBuild}
            </button>
            <button type="button" onClick={leaveGuide}>
              {t.toAll}
            </button>
          </>
        )}
        <Ways step="run" isReady />
      </section>
    </>
  );
}
