// Steps by states, in the run bar, while the run stands: into, over, out, and step mode.
import { useCore, useLogin, useSession, useView } from "../client";
import { useStop } from "../../stop/useStop";
import { isOver } from "../../shared/run/controls";
import { Icon, type IconName } from "../panels/Icon";
import { commandOf, keysOfCommand, runDebugCommand } from "./actions";

const kButtons: readonly { readonly id: string; readonly icon: IconName }[] = [
  { id: "step_into", icon: "into" },
  { id: "step_over", icon: "over" },
  { id: "step_out", icon: "out" },
  { id: "step_mode", icon: "steps" },
];

export function StepButtons() {
  const core = useCore();
  if (core === undefined || isOver(core) || (core.status === "running" && !core.paused)) return null;
  return (
    <div className="step-buttons" role="group" aria-label="Steps by states">
      {kButtons.map((button) => (
        <StepButton key={button.id} {...button} />
      ))}
    </div>
  );
}

function StepButton({ id, icon }: (typeof kButtons)[number]) {
  const command = commandOf(id);
  // It depends on the selection, on the account, on the stop, and on the run.
  useView(() => command.when());
  useLogin(() => command.when());
  useStop(() => command.when());
  const reason = useSession(() => command.when());
  const keys = keysOfCommand(command);
  const text = `${command.name} (${keys})`;
  return (
    <button type="button" disabled={reason !== undefined} aria-label={command.name} aria-keyshortcuts={keys} title={reason === undefined ? text : `${text}: ${reason}`} onClick={() => runDebugCommand(command)}>
      <Icon name={icon} />
    </button>
  );
}
