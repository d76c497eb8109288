// The services and their operations: dragged onto the drawing, or by Enter, a state is added that calls one. Folded, as there may be many.
import { memo, useState } from "react";
import type { RsmOperation } from "../../generated/messages";
import type { KnownService } from "../../shared/code/services";
import { counted } from "../../shared/counted";
import { placeIn } from "../../shared/edit/commands/place";
import { newId } from "../../shared/newId";
import { addOperation } from "../../shared/skills/addOperation";
import { offeredOperations } from "../../shared/skills/operationState";
import { useSession } from "../client";
import { useRefusal } from "../login/rights";
import { placeFor } from "./actions/addActions";
import { carryOut } from "./carryOut";
import { useKnownServices } from "./forms/useKnownServices";
import { followPointer } from "./gestures/drag";
import { dropNew, type NewThing } from "./gestures/dropNew";
import { situationNow } from "./situation";

export function ServicePalette() {
  const services = useKnownServices();
  // A text, which is the same until a service comes or goes.
  const away = useSession((s) => s.services.filter(({ available }) => !available).map(({ key }) => key).join(" ")).split(" ");
  const refusal = useRefusal("edit");
  return (
    <section className="service-palette" aria-label="Operations of services">
      <h2>Services</h2>
      {services.length === 0 && <p className="quiet">The server has no services.</p>}
      <ul className="service-list">
        {services.map((service) => (
          <Service key={service.key} service={service} isAway={away.includes(service.key)} refusal={refusal} />
        ))}
      </ul>
      <HowToConnect />
    </section>
  );
}

interface ServiceProps {
  readonly service: KnownService;
  readonly isAway: boolean;
  /** Why nothing can be added. */
  readonly refusal: string | undefined;
}

const Service = memo(function Service({ service, isAway, refusal }: ServiceProps) {
  const [isOpen, setOpen] = useState(false);
  const operations = offeredOperations(service);
  return (
    <li data-service={service.key}>
      <details onToggle={(event) => setOpen(event.currentTarget.open)}>
        <summary title={isAway ? `${service.key} is not there now: calls are answered \`unavailable\`` : undefined}>
          {service.key} <small>{isAway ? "not there now" : counted(operations.length, "operation")}</small>
        </summary>
        {isOpen && (
          <ul>
            {operations.map((operation) => (
              <Operation key={operation.name} service={service} operation={operation} refusal={refusal} />
            ))}
          </ul>
        )}
        {isOpen && operations.length === 0 && <p className="quiet">It has no operation that a state can call.</p>}
      </details>
    </li>
  );
});

interface OperationProps extends Omit<ServiceProps, "isAway"> {
  readonly operation: RsmOperation;
}

const callOf = (service: KnownService, operation: RsmOperation): NewThing => ({
  name: `${service.key}.${operation.name}`, onto: "composite", make: (tree, parent) => addOperation(tree, placeIn(tree, parent), service, operation, newId),
});

/** A state that calls it where something new would go. */
function callHere(service: KnownService, operation: RsmOperation): void {
  const situation = situationNow();
  if (situation !== undefined) carryOut(addOperation(situation.tree, placeFor(situation), service, operation, newId));
}

function Operation({ service, operation, refusal }: OperationProps) {
  const { name, parameters = [], doc } = operation;
  const hint = "Drag onto the drawing, or press Enter, for a state that calls it";
  return (
    <li>
      <button
        type="button"
        className="palette-item"
        data-operation={`${service.key}.${name}`}
        disabled={refusal !== undefined}
        title={refusal ?? (doc === undefined ? hint : `${doc}\n${hint}`)}
        onPointerDown={(event) => event.button === 0 && followPointer(event, () => dropNew(callOf(service, operation)))}
        onClick={() => callHere(service, operation)}
      >
        {name} <small>{parameters.map((parameter) => parameter.name).join(", ")}</small>
      </button>
    </li>
  );
}

function HowToConnect() {
  return (
    <details>
      <summary>Connect one of your own</summary>
      <p className="quiet">
        A program that offers it is listed here at once. The template is one; it is started in the folder of RACE:
        <code>PYTHONPATH=api/python python3 api/templates/gripper_python/gripper.py --server {location.origin}</code>
        The file api/tutorial.md says how to make your own of it.
      </p>
    </details>
  );
}
