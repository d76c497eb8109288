// All services: the data flows between them, and each with its RSM, the present state lit, what is pending and what the monitor found.
import { useSession } from "../client";
import { askPairing } from "../pairing/pairing";
import { DataFlows } from "./DataFlows";
import { ServiceCard } from "./ServiceCard";

export function ServicesView() {
  const services = useSession((s) => s.services);
  return (
    <section className="services" aria-label="Services">
      <div className="services-head">
        <p className="quiet">A phone can be a display: tasks show questions on it, and a person answers there.</p>
        <button type="button" aria-haspopup="dialog" onClick={() => askPairing(true)}>
          Pair a phone
        </button>
      </div>
      {services.length === 0 && <p className="quiet pad">The server has no services.</p>}
      <DataFlows services={services} />
      {services.map((service) => (
        <ServiceCard key={service.key} service={service} />
      ))}
    </section>
  );
}
