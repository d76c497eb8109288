// The moment of the past that is shown, where the properties of the run stand: its status, what waited, the newest events, the open calls, and its digests.
import type { Core, Past } from "../../generated/messages";
import { valueText } from "../../shared/model/describe";
import { momentText } from "../../shared/past/moment";
import { pastStatus, placeText, shortDigest } from "../../shared/past/texts";
import { statusLook } from "../../shared/run/controls";
import { view } from "../client";
import { InputList } from "../panels/InputList";
import { CallList } from "../panels/OpenCalls";
import { visitStep } from "./past";
import { PastPicture } from "./PastPicture";

interface Props {
  readonly core: Core;
  readonly past: Past;
}

export function PastProperties({ core, past }: Props) {
  return (
    <>
      <header className="prop-head">
        <small>
          Run {core.id} of {core.document}, as it was
        </small>
        <h2>Step {momentText(past)}</h2>
        <span className={`pill is-${statusLook({ status: past.status, paused: false, outcome: past.outcome })}`}>{pastStatus(past)}</span>
      </header>
      <section aria-label="Moment">
        <p className="quiet">{placeText(past)}</p>
        <dl className="pairs">
          <dt>Digest</dt>
          <dd>
            <code title={`${past.digest}: equal for equal moments of this run, however they are reached`}>{shortDigest(past.digest)}</code>
          </dd>
          {past.waiting !== undefined && (
            <>
              <dt>Digest of what waited</dt>
              <dd>
                <code title={`${past.waiting.digest}: equal if the same inputs waited`}>{shortDigest(past.waiting.digest)}</code>
              </dd>
            </>
          )}
        </dl>
      </section>
      <PastPicture core={core} step={past.step} />
      <InputList waiting={past.waiting} unknown="What waited then is not known." none="None: nothing had come that was not delivered yet." about={(step) => (step === undefined ? "not delivered" : <DeliveredIn step={step} />)} />
      <CallList calls={past.open_calls.map(({ call, caller, service, operation }) => ({ service, operation, about: <CalledBy call={call} caller={caller} /> }))} empty="None: every call was answered." />
      <NewestEvents past={past} />
      <p className="quiet">Select a state, a barrier or a port to see the values that it had.</p>
    </>
  );
}

function DeliveredIn({ step }: { readonly step: number }) {
  return (
    <>
      delivered in{" "}
      <button type="button" className="link" onClick={() => visitStep(step)}>
        step {step}
      </button>
    </>
  );
}

function CalledBy({ call, caller }: { readonly call: number; readonly caller: string }) {
  return (
    <>
      call {call} by{" "}
      <button type="button" className="link" onClick={() => view.dispatch({ type: "jump", selection: { kind: "node", path: caller } })}>
        {caller}
      </button>
    </>
  );
}

function NewestEvents({ past: { events } }: { readonly past: Past }) {
  return (
    <section aria-label="Newest events">
      <h3>Newest events, Σ</h3>
      {events.length === 0 && <p className="quiet">No event had come.</p>}
      <ul className="past-list">
        {events.map(({ service, event, data }) => (
          <li key={`${service}.${event}`}>
            <code>
              {service}.{event}
            </code>
            {data !== null && (
              // Long data scroll, by keyboard too.
              <code className="past-data" tabIndex={0}>
                {valueText(data)}
              </code>
            )}
          </li>
        ))}
      </ul>
    </section>
  );
}
