// Whether the condition of a port holds in the run, beside its field, while its state is active.
import { entryOf } from "../../shared/json";
import { askableAddress, elementOfRun } from "../../shared/live/values";
import { portAddress } from "../../shared/model/model";
import { truthText } from "../../shared/run/whyText";
import { whenText } from "../../shared/past/moment";
import { isStored } from "../../shared/session/session";
import { useSession } from "../client";
import { useEditing } from "../edit/editing";
import { useExecuted } from "./executed";
import { useShownRun } from "./shownRun";
import { useWhy } from "./useWhy";

export function ConditionNow({ id }: { readonly id: string }) {
  const core = useShownRun((shown) => shown.core);
  const run = useShownRun((shown) => shown.run);
  const address = useShownRun(({ tree, run: now }) => askableAddress(tree, now, id));
  const isFired = useShownRun(({ tree, run: now }) => {
    const found = elementOfRun(tree, id);
    return found?.kind === "port" && now.ports.includes(portAddress(found.path, found.element));
  });
  const past = useSession((s) => s.past?.past);
  const stored = useSession(isStored);
  const answer = useWhy(address === undefined ? undefined : { port: address }, run, past);
  const edited = useEditing(({ session }) => session?.view?.elements.get(id)?.fields);
  const executed = useExecuted();
  if (core === undefined) return null;
  if (isFired === true) return <p className="row-now">has fired</p>;
  // A state that has been left meanwhile has nothing to say.
  if (answer === undefined || "failed" in answer || !("condition" in answer.why)) return null;
  const before = executed === undefined || "reason" in executed ? undefined : executed.elements.get(id)?.fields;
  const isOther = before !== undefined && (entryOf(before, "when") !== entryOf(edited, "when") || entryOf(before, "after") !== entryOf(edited, "after"));
  return (
    <p className="row-now">
      {isOther && `in revision ${core.revision}, `}
      {`${whenText(past, stored)}: ${truthText(answer.why.value)}`}
    </p>
  );
}
