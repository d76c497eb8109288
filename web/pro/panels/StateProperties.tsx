// A selected state: its interface with live values, its functions in full, its ports, and stepping to it.
import { Fragment } from "react";
import { kOfState } from "../../shared/debugger/places";
import type { State } from "../../shared/model/model";
import { allowed, until } from "../../shared/run/controls";
import { portText, valueText } from "../../shared/model/describe";
import { stateShown } from "../../shared/past/shown";
import { commandable } from "../../shared/session/session";
import { useSession, view } from "../client";
import { RunComments } from "../comments/RunComments";
import { ActionBreakpoint, BreakpointChoices } from "../debugger/BreakpointChoices";
import { useRefusalOfCommand } from "../login/rights";
import { Code } from "./Code";
import { command } from "./startAsk";
import { ValueTable } from "./ValueTable";
import { WhyAnswer, WhyButton } from "./WhyOf";

export function StateProperties({ path, state }: { readonly path: string; readonly state: State }) {
  const live = useSession(stateShown);
  const active = live?.active.includes(path) === true;
  const sources = Object.fromEntries(
    state.parameters.flatMap((p) => (p.from !== undefined ? [[p.name, `← ${p.from}`]] : p.value !== undefined ? [[p.name, `= ${valueText(p.value)}`]] : [])),
  );
  return (
    <>
      <header className="prop-head">
        <small>State · {path}</small>
        <h2>{state.name}</h2>
        <span className={`pill ${active ? "is-running" : ""}`}>{active ? "Active" : "Inactive"}</span>
      </header>
      {state.doc !== undefined && <p className="doc">{state.doc}</p>}
      <StepTo path={path} state={state} />
      <BreakpointChoices kinds={kOfState} />
      <ValueTable title="Parameters" names={state.parameters.map((p) => p.name)} values={live?.parameters.get(path)} notes={sources} forced={{ path, scope: "par" }} parametersOf={path} />
      <ValueTable title="Results" names={state.results.map((r) => r.name)} values={live?.results.get(path)} forced={{ path, scope: "res" }} />
      <ValueTable title="Variables" names={state.variables.map((v) => v.name)} values={live?.variables.get(path)} forced={{ path, scope: "var" }} />
      {state.entry !== undefined && <Code title="Entry" code={state.entry} />}
      {state.actions.map((action, i) => (
        <Fragment key={i}>
          <Code title={`Action ${i + 1}`} condition={action.when} code={action.do}>
            <ActionBreakpoint id={action.id} />
            <WhyButton asked={{ action: i }} name={`action ${i + 1} is executed or not`} />
          </Code>
          <WhyAnswer path={path} asked={{ action: i }} />
        </Fragment>
      ))}
      {state.exit !== undefined && <Code title="Exit" code={state.exit} />}
      <PortList path={path} state={state} />
      <RunComments id={state.id} />
    </>
  );
}

function StepTo({ path, state }: { readonly path: string; readonly state: State }) {
  const can = allowed(useSession(commandable)).has("until");
  const past = useSession((s) => s.past !== undefined);
  const refusal = useRefusalOfCommand("until");
  if (!can) return null;
  return (
    <div className="step-to" role="group" aria-label="Run until">
      {past && <span className="of-present">The present</span>}
      <button type="button" disabled={refusal !== undefined} title={refusal} onClick={() => command("until", until(state, path, "entered"))}>
        Run until entered
      </button>
      <button type="button" disabled={refusal !== undefined} title={refusal} onClick={() => command("until", until(state, path, "left"))}>
        Run until left
      </button>
    </div>
  );
}

function PortList({ path, state }: { readonly path: string; readonly state: State }) {
  const active = useSession((s) => stateShown(s)?.ports);
  if (state.ports.length === 0) return null;
  return (
    <section aria-label="Ports">
      <h3>Ports, in order of evaluation</h3>
      <ul className="port-list">
        {state.ports.map((port) => {
          const address = `${path}.${port.name}`;
          return (
            <li key={port.name}>
              <button type="button" onClick={() => view.dispatch({ type: "select", selection: { kind: "port", address } })}>
                <span className={active?.includes(address) === true ? "lit" : ""}>
                  {port.name}
                  <small>{port.to === undefined ? "exits" : `→ ${port.to}`}</small>
                </span>
                <code>{portText(port)}</code>
              </button>
            </li>
          );
        })}
      </ul>
    </section>
  );
}
