// Beside a value of a running run: the way to force it.
import type { JsonValue } from "../../shared/json";
import { reasonAgainstForce, type Proposal } from "../../shared/debugger/force";
import { commandable } from "../../shared/session/session";
import { useSession } from "../client";
import { useRefusal } from "../login/rights";
import { propose } from "./forcing";

interface Props extends Pick<Proposal, "path" | "scope" | "name"> {
  readonly value: JsonValue | undefined;
}

export function ForceValue({ value, ...of }: Props) {
  const can = reasonAgainstForce(useSession(commandable)) === undefined;
  const refusal = useRefusal("force");
  const past = useSession((s) => s.past !== undefined);
  if (!can || past) return null;
  return (
    <button type="button" className="force-value" aria-label={`Force ${of.name}`} disabled={refusal !== undefined} title={refusal ?? "Set it in the run"} onClick={() => propose({ ...of, text: value === undefined ? "" : JSON.stringify(value) })}>
      ✎
    </button>
  );
}
