// In the properties of a state, port or action: the kinds of breakpoints at it, each set or not.
import { isAt, type Where } from "../../shared/debugger/breakpoints";
import { whenTexts, whenTitles } from "../../shared/debugger/places";
import type { When } from "../../generated/messages";
import { useView } from "../client";
import { useRefusal } from "../login/rights";
import { changeBreakpoints } from "./breakpoints";
import { useKept } from "./kept";
import { targetOf, useShownTree } from "./target";

interface ChoiceProps {
  readonly when: When;
  readonly where: Where;
  readonly name: string;
}

function Choice({ when, where, name }: ChoiceProps) {
  const entry = useKept(({ entries }) => entries.find((each) => isAt(each, when, where)));
  const refusal = useRefusal("set_breakpoints");
  const state = entry === undefined ? "" : entry.breakpoint.enabled ? " is-on" : " is-off";
  return (
    <button type="button" className={`breakpoint-choice${state}`} aria-pressed={entry !== undefined} disabled={refusal !== undefined} title={refusal ?? `Breakpoint: ${whenTitles[when]}`} onClick={() => changeBreakpoints({ type: "toggled", when, where })}>
      <i className={`breakpoint-dot${state}`} aria-hidden="true" />
      {name}
    </button>
  );
}

/** Of what is selected. */
export function BreakpointChoices({ kinds }: { readonly kinds: readonly When[] }) {
  const tree = useShownTree();
  const selection = useView((v) => v.selection);
  const loaded = useKept((kept) => kept.loaded);
  const target = targetOf(tree, selection);
  if (target === undefined || !loaded) return null;
  return (
    <div className="breakpoint-choices" role="group" aria-label="Breakpoints here">
      {kinds.map((when) => (
        <Choice key={when} when={when} where={target.where} name={when === "into" ? "into" : when === "fulfilled" ? "condition" : whenTexts[when]} />
      ))}
    </div>
  );
}

/** One at an action, by its id; one without has none. */
export function ActionBreakpoint({ id }: { readonly id: string | undefined }) {
  const entry = useKept(({ entries }) => (id === undefined ? undefined : entries.find((each) => isAt(each, "executed", { id }))));
  const loaded = useKept((kept) => kept.loaded);
  const refusal = useRefusal("set_breakpoints");
  if (id === undefined || id === "" || !loaded) return null;
  const state = entry === undefined ? "" : entry.breakpoint.enabled ? " is-on" : " is-off";
  return (
    <button
      type="button"
      className={`breakpoint-gutter${state}`}
      aria-label="Breakpoint at this action"
      aria-pressed={entry !== undefined}
      disabled={refusal !== undefined}
      title={refusal ?? "Breakpoint: this action is executed"}
      onClick={() => changeBreakpoints({ type: "toggled", when: "executed", where: { id } })}
    >
      <i className={`breakpoint-dot${state}`} aria-hidden="true" />
    </button>
  );
}
