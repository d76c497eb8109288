// From a field of the editor to the page of the run, which explains its port, action or parameter.
import { explainedAt } from "../../shared/live/values";
import { view } from "../client";
import { shownRun, useShownRun } from "./shownRun";

/** `name`: of what, for those who do not see the row. */
export function WhyLink({ id, name }: { readonly id: string; readonly name: string }) {
  const isThere = useShownRun(({ tree }) => explainedAt(tree, id) !== undefined) === true;
  if (!isThere) return null;
  const lead = () => {
    const tree = shownRun()?.tree;
    const explained = tree && explainedAt(tree, id);
    if (explained === undefined) return;
    view.dispatch({ type: "page", page: "task" });
    view.dispatch({ type: "jump", selection: explained.selection });
    view.dispatch({ type: "ask", asked: explained.asked });
  };
  return (
    <button type="button" className="link why-button" aria-label={`Why, in the run: ${name}`} title="Why it is so in the run" onClick={lead}>
      Why?
    </button>
  );
}
