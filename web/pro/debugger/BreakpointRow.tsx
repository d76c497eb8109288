// One breakpoint of the list: enabled or not, its place as a link, before or after, its operation, its condition, and what is wrong with it.
import type { KeptBreakpoint } from "../../generated/messages";
import { asSent, type Entry, type Fields } from "../../shared/debugger/breakpoints";
import { breakpointKey } from "../../shared/debugger/onCore";
import { operationChoices, operationKey } from "../../shared/debugger/operations";
import { breakpointText, placeText, selectionOf, whenTexts, whenTitles } from "../../shared/debugger/places";
import type { ModelTree } from "../../shared/model/modelTree";
import { view } from "../client";
import { useKnownServices } from "../edit/forms/useKnownServices";
import { changeBreakpoints } from "./breakpoints";
import { ConditionInput } from "./ConditionInput";
import { useKept } from "./kept";

interface Props {
  readonly entry: Entry;
  readonly tree: ModelTree | undefined;
}

export function BreakpointRow({ entry: { number, breakpoint }, tree }: Props) {
  const refused = useKept((kept) => (breakpoint.enabled ? kept.refused.get(breakpointKey(asSent(breakpoint))) : undefined));
  const set = (fields: Fields) => changeBreakpoints({ type: "set", number, fields });
  const name = breakpointText(tree, breakpoint);
  const { enabled, before = false, when } = breakpoint;
  return (
    <li aria-label={name}>
      <div className="breakpoint-line">
        <button type="button" className={`breakpoint-gutter ${enabled ? "is-on" : "is-off"}`} aria-pressed={enabled} aria-label={`Enabled: ${name}`} title={enabled ? "Disable" : "Enable"} onClick={() => set({ enabled: !enabled })}>
          <i className={`breakpoint-dot ${enabled ? "is-on" : "is-off"}`} aria-hidden="true" />
        </button>
        <Place breakpoint={breakpoint} tree={tree} />
        <small title={whenTitles[when]}>{whenTexts[when]}</small>
        <button type="button" className="row-remove" aria-label={`Remove the breakpoint ${name}`} title="Remove" onClick={() => changeBreakpoints({ type: "removed", number })}>
          ✕
        </button>
      </div>
      {when === "called" && <OperationChoice breakpoint={breakpoint} onChoose={set} />}
      <div className="breakpoint-line">
        <button
          type="button"
          className="row-kind"
          disabled={when === "fault"}
          aria-label={before ? "Pauses before it: make it after" : "Pauses after it: make it before"}
          title={before ? "Pauses before the micro step in which it happens" : "Pauses after the micro step in which it happens"}
          onClick={() => set({ before: !before })}
        >
          {before ? "before" : "after"}
        </button>
        <ConditionInput breakpoint={breakpoint} value={breakpoint.condition ?? ""} isRequired={when === "fulfilled"} wrong={refused !== undefined} onCommit={(condition) => set({ condition })} />
      </div>
      {refused !== undefined && <p className="breakpoint-error">Not in the run: {refused}</p>}
    </li>
  );
}

function Place({ breakpoint, tree }: { readonly breakpoint: KeptBreakpoint; readonly tree: ModelTree | undefined }) {
  const selection = tree && selectionOf(tree, breakpoint);
  const text = placeText(tree, breakpoint);
  if (selection === undefined) return <span className="breakpoint-place">{text}</span>;
  return (
    <button type="button" className="link breakpoint-place" title={selection.kind === "node" ? selection.path : selection.address} onClick={() => view.dispatch({ type: "jump", selection })}>
      {text}
    </button>
  );
}

function OperationChoice({ breakpoint, onChoose }: { readonly breakpoint: KeptBreakpoint; readonly onChoose: (fields: Fields) => void }) {
  const choices = operationChoices(useKnownServices(), breakpoint);
  return (
    <select aria-label="Operation" value={operationKey(breakpoint)} onChange={({ target }) => {
      const { service = "", operation = "" } = choices.find((each) => operationKey(each) === target.value) ?? {};
      onChoose({ service, operation });
    }}>
      {choices.map((each) => (
        <option key={operationKey(each)} value={operationKey(each)}>
          {each.text}
        </option>
      ))}
    </select>
  );
}
