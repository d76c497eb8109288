// One service: header, drawing, pending calls, violations.
import type { HostedService } from "../../generated/messages";
import { RsmFigure } from "./RsmFigure";

export function ServiceCard({ service }: { readonly service: HostedService }) {
  return (
    <article className="service" aria-label={`Service ${service.key}`}>
      <header>
        <h2>{service.key}</h2>
        {service.type !== service.key && <small>{service.type}</small>}
        <span className={`pill ${service.available ? "is-running" : "is-faulted"}`}>
          {service.available ? (service.state ?? "available") : "unavailable"}
        </span>
      </header>
      {(service.rsm.states ?? []).length > 0 ? (
        <RsmFigure rsm={service.rsm} state={service.state} last={service.last} />
      ) : (
        <p className="quiet">An interface without states.</p>
      )}
      <p className="events">
        {service.rsm.events.map((event) => (
          <code key={event.name} title={event.sampled === true ? "sampled: only the newest value waits" : "event"}>
            {event.sampled === true ? "∿ " : "⚡ "}
            {event.name}
          </code>
        ))}
      </p>
      <Pending service={service} />
      <Violations service={service} />
    </article>
  );
}

function Pending({ service }: { readonly service: HostedService }) {
  const more = service.pending_count - service.pending.length;
  return (
    <section aria-label={`Pending calls of ${service.key}`}>
      <h3>Pending calls</h3>
      {service.pending.length === 0 ? (
        <p className="quiet">None.</p>
      ) : (
        <ul className="pending">
          {service.pending.map((call) => (
            <li key={call.call}>
              <code>{call.operation}</code>
              <span>
                call {call.call}
                {call.core === undefined ? "" : ` of run ${call.core}`} · since {call.time.toFixed(2)} s
              </span>
            </li>
          ))}
        </ul>
      )}
      {more > 0 && <p className="quiet">and {more} more</p>}
    </section>
  );
}

function Violations({ service }: { readonly service: HostedService }) {
  if (service.violations.length === 0) return null;
  return (
    <section className="violations" aria-label={`Violations of ${service.key}`}>
      <h3>Left its model</h3>
      <ul>
        {service.violations.map((violation, i) => (
          <li key={i}>
            <b>{violation.rule}</b> {violation.message}
            <small>
              {violation.time.toFixed(2)} s{violation.call === undefined ? "" : ` · call ${violation.call}`}
            </small>
          </li>
        ))}
      </ul>
    </section>
  );
}
