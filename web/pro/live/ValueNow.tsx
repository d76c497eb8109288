// The value that a parameter, result or variable has in the run, beside its field.
import { parameterText } from "../../shared/live/texts";
import { isActiveNow, valueNow } from "../../shared/live/values";
import { entryOf } from "../../shared/json";
import { valueText } from "../../shared/model/describe";
import { isSame } from "../../shared/edit/difference/same";
import { useEditing } from "../edit/editing";
import { useExecuted } from "./executed";
import { useShownRun } from "./shownRun";

const useNow = (id: string) => useShownRun(({ tree, run }) => valueNow(tree, run, id));

export function ParameterNow({ id }: { readonly id: string }) {
  const now = useNow(id);
  const isActive = useShownRun(({ tree, run }) => isActiveNow(tree, run, id)) === true;
  const core = useShownRun((shown) => shown.core);
  const fields = useEditing(({ session }) => session?.view?.elements.get(id)?.fields);
  const isArgument = useEditing(({ session }) => session?.view?.elements.get(id)?.parent === session?.view?.root);
  const executed = useExecuted();
  if (core === undefined) return null;
  const constant = entryOf(fields, "value");
  const inRun = executed === undefined || "reason" in executed ? undefined : entryOf(executed.elements.get(id)?.fields, "value");
  const text = parameterText({ now, constant, isArgument, isActive, isExecuted: isSame(constant, inRun), core });
  return text === undefined ? null : <p className="row-now">{text}</p>;
}

export function ValueNow({ id }: { readonly id: string }) {
  const now = useNow(id);
  return now === undefined ? null : <p className="row-now">now: {valueText(now)}</p>;
}
