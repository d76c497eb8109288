// Over the whole width, while a moment of the past is shown, or a run that is stored: that this is not the present, and the ways through it.
import { pastText } from "../../shared/past/texts";
import { storedText } from "../../shared/runs/texts";
import { keysOf } from "../../shared/session/shortcuts";
import { isStored } from "../../shared/session/session";
import { useCore, useSession } from "../client";
import { Icon } from "../panels/Icon";
import { move, toPresent, useAsked, visit } from "./past";

export function PastBanner() {
  const core = useCore();
  const shown = useSession((s) => s.past);
  const stored = useSession(isStored);
  const asked = useAsked();
  if (core === undefined || (shown === undefined && !stored)) return null;
  const past = shown?.past;
  const text = past === undefined ? storedText(core) : pastText(past, core, stored);
  const step = asked ?? past?.step ?? core.step;
  return (
    <section className={`past-banner${past === undefined ? " is-end" : ""}`} aria-label="Past">
      <p role="status" aria-label="Moment">
        <strong>{text.title}</strong> <span>{text.holds}</span>
        {shown?.doubt !== undefined && <em>{shown.doubt}</em>}
      </p>
      {core.step > 0 && (
        <div className="past-ways" role="toolbar" aria-label="Through the past">
          <button type="button" title={`Back (${keysOf("back")})`} aria-keyshortcuts={keysOf("back")} onClick={() => move("back")}>
            <Icon name="back" />
            Back
          </button>
          <input
            type="range"
            aria-label="Macro step"
            min={1}
            max={core.step}
            value={step}
            aria-valuetext={`Macro step ${step} of ${core.step}`}
            onChange={(event) => visit({ step: Number(event.target.value) }, past === undefined ? "push" : "replace")}
          />
          <button type="button" disabled={past === undefined} title={`Forward (${keysOf("forward")})`} aria-keyshortcuts={keysOf("forward")} onClick={() => move("forward")}>
            <Icon name="forward" />
            Forward
          </button>
          <button type="button" disabled={past === undefined} title={`${stored ? "To the end of the run" : "To the present"} (Esc)`} onClick={() => toPresent()}>
            {stored ? "End" : "Now"}
          </button>
        </div>
      )}
    </section>
  );
}
