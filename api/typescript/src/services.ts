// Services: what they offer (RSM), and calls of their operations.
import { callService, listServices } from "./calls/services.js";
import { ServiceError } from "./errors.js";
import type { Exact } from "./exact.js";
import type { HostedService, ServiceCall, ServiceResponse } from "./generated/messages.js";
import type { JsonValue } from "./json.js";
import type { ControlOptions } from "./cores.js";
import type { Sender, SendOptions } from "./sender.js";

type Positional = Exact<NonNullable<ServiceCall["args"]>>;
type Named = Exact<NonNullable<ServiceCall["kwargs"]>>;

/** The result of a call (none: null). Throws a ServiceError if the service has answered an error. */
export function resultOf(service: string, operation: string, { result, error }: ServiceResponse): JsonValue {
  if (error !== undefined) throw new ServiceError(service, operation, error);
  return result ?? null;
}

/** The services of the server, by their keys, as in `svc.KEY`. */
export class Services {
  constructor(private readonly client: Sender) {}

  /** All services: `key`, present `state`, whether it is `available`, and its `rsm` with operations, their parameters and units. */
  async all(options?: SendOptions): Promise<readonly HostedService[]> {
    return (await this.client.send(listServices(), options)).services;
  }

  /**
   * Calls an operation, with arguments by position (a list) and name (an object), as its RSM has them; its result (none: null).
   *
   * ServiceError: the service answers with an error, of which `code` and `error` say more; `unavailable` also: it has no such operation.
   * RaceError 404: no such service; 409 `leased`: it moves something, or somebody else has the controls; 429 and 503 `unavailable`: too
   * many wait, or there was no response within 5 s, and what it began may go on.
   */
  async call(service: string, operation: string, args: Positional = [], kwargs: Named = {}, { control, ...options }: ControlOptions = {}): Promise<JsonValue> {
    const response = await this.client.send(callService(service, { operation, args, kwargs }, { raceControl: control }), options);
    return resultOf(service, operation, response);
  }
}
