// The data flows between services (thesis 4.1), which bypass the cores: a drawing, a list, and the packets of one of them.
import { useRef, useState } from "react";
import type { HostedService } from "../../generated/messages";
import { flowText } from "../../shared/service/flowText";
import { FlowFigure } from "./FlowFigure";
import { FlowWatch } from "./FlowWatch";

export function DataFlows({ services }: { readonly services: readonly HostedService[] }) {
  const [watched, setWatched] = useState<string>();
  const opener = useRef<HTMLButtonElement | null>(null);
  const offered = services.flatMap((service) => service.publishes.map((published) => ({ service, published, name: `${service.key}.${published.flow}` })));
  if (offered.length === 0) return null;
  const shown = offered.find(({ name }) => name === watched);
  const close = () => {
    setWatched(undefined);
    opener.current?.focus();
  };
  return (
    <section
      className="data-flows"
      aria-label="Data flows"
      onKeyDown={(event) => {
        if (event.key !== "Escape" || watched === undefined) return;
        event.stopPropagation();
        close();
      }}
    >
      <div>
        <h2>Data flows</h2>
        <p className="quiet">Solid arrows: packets from service to service, past the cores; thick while they pass.</p>
        <FlowFigure services={services} />
        <ul>
          {offered.map(({ service, published, name }) => (
            <li key={name}>
              <code>{name}</code>
              <span className="quiet flow-description">{flowText(service.rsm, published.flow)}</span>
              <span className="quiet">{published.rate_hz > 0 ? `${published.rate_hz.toFixed(1)} packets/s` : service.available ? "idle" : "unavailable"}</span>
              <button
                className="flow-open"
                aria-pressed={watched === name}
                aria-label={`Watch ${name}`}
                onClick={(event) => {
                  opener.current = event.currentTarget;
                  setWatched(watched === name ? undefined : name);
                }}
              >
                Watch
              </button>
            </li>
          ))}
        </ul>
      </div>
      {shown !== undefined && <FlowWatch key={shown.name} service={shown.service.key} published={shown.published} onClose={close} />}
    </section>
  );
}
