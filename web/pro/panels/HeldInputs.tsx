// What waits for a run that is paused: a response or an event that has come looks like none until a step delivers it.
import type { Core } from "../../generated/messages";
import { InputList } from "./InputList";
import { useHeld } from "./useHeld";

export function HeldInputs({ core }: { readonly core: Core }) {
  const { holds, waiting } = useHeld(core);
  if (!holds) return null;
  return <InputList waiting={waiting} unknown="Asking the server what waits…" none="None." about={(_, at) => (at === 0 ? "the next step delivers it" : "waits behind")} />;
}
