// What happened to an interrupted run, above the run bar with the ways out: resume, step, stop.
import { interruptionText } from "../../shared/run/interruption";
import { useCore } from "../client";
import { CodeText } from "./CodeText";
import { Icon } from "./Icon";

export function Interruption() {
  const core = useCore();
  const text = core === undefined ? undefined : interruptionText(core);
  if (text === undefined) return null;
  return (
    <div className="interruption" role="alert" aria-label="Interruption">
      <Icon name="interrupted" />
      <div>
        <strong>{text.title}</strong>
        {text.happened !== undefined && (
          <p>
            <CodeText text={text.happened} />
          </p>
        )}
        <p>
          <CodeText text={text.holds} />
        </p>
      </div>
    </div>
  );
}
