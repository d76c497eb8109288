// The moment of the past that is shown, where the properties of the run stand: its status, the newest events, the open calls, and its digest.
import type { Core, Past } from "../../generated/messages";
import { valueText } from "../../shared/model/describe";
import { momentText } from "../../shared/past/moment";
import { pastStatus, placeText, shortDigest } from "../../shared/past/texts";
import { view } from "../client";

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
        <span className={`pill is-${past.status}`}>{pastStatus(past)}</span>
      </header>
      <section aria-label="Moment">
        <p className="quiet">{placeText(past)}</p>
        <dl className="pairs">
          <dt>Digest</dt>
          <dd>
            <code title={`${past.digest}: equal for equal moments of this run, however they are reached`}>{shortDigest(past.digest)}</code>
          </dd>
        </dl>
      </section>
      <OpenCalls past={past} />
      <NewestEvents past={past} />
      <p className="quiet">Select a state, a barrier or a port to see the values that it had.</p>
    </>
  );
}

function OpenCalls({ past: { open_calls: calls } }: { readonly past: Past }) {
  return (
    <section aria-label="Open calls">
      <h3>Open calls</h3>
      {calls.length === 0 && <p className="quiet">None: every call was answered.</p>}
      <ul className="past-list">
        {calls.map(({ call, caller, service, operation }) => (
          <li key={call}>
            <code>
              {service}.{operation}
            </code>
            <small>
              call {call} by{" "}
              <button type="button" className="link" onClick={() => view.dispatch({ type: "jump", selection: { kind: "node", path: caller } })}>
                {caller}
              </button>
            </small>
          </li>
        ))}
      </ul>
    </section>
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
            {data !== null && <code className="past-data">{valueText(data)}</code>}
          </li>
        ))}
      </ul>
    </section>
  );
}
