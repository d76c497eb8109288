// What is read on the displays now, so that who sits at this page reads it too; and that this page is a display, with the way out.
import { displayAddress, displayOf, displaysText, isAsking } from "../../shared/run/displayCalls";
import { isOver } from "../../shared/run/controls";
import { textOn } from "../../shared/run/onDisplays";
import { useCore, useSession } from "../client";
import { endDisplay, useOwnDisplays } from "./ownDisplay";
import { usePersonWait, useUnseen } from "./question";

export function OnDisplays() {
  const core = useCore();
  const shown = useSession((s) => s.onDisplays.shown);
  const unseen = useUnseen();
  const isAsked = usePersonWait() !== undefined;
  const own = useOwnDisplays();
  const call = unseen !== undefined && !isAsking(unseen.call.operation) ? unseen.call : shown;
  const text = call !== undefined && core !== undefined && !isOver(core) && !isAsked ? textOn(call) : undefined;
  if (text === undefined && own.length === 0) return null;
  return (
    <div className="on-displays">
      {call !== undefined && text !== undefined && (
        <p role="status" aria-label="On the displays">
          {call === unseen?.call ? "No display is connected, so this is shown nowhere" : `Told on ${displaysText(displayOf(call))}`}: <strong>{text}</strong>{" "}
          <a href={displayAddress(displayOf(call))} target="_blank" rel="noreferrer">
            Open a display
          </a>
        </p>
      )}
      {own.map((name) => (
        <p key={name}>
          This page acts as the display {name}.{" "}
          <button type="button" className="link" onClick={() => endDisplay(name)}>
            Disconnect
          </button>
        </p>
      ))}
    </div>
  );
}
