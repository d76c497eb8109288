// Routes of api/openapi.yaml: services. Made by api/python/generate/main.py. The request filter may also refuse each.
import { segment, type Body, type Call } from "../call.js";
import type { ServiceCall, ServiceResponse, Services } from "../generated/messages.js";
import * as schema from "../generated/validators.js";

/**
 * The services of the server with RSM, state, pending calls, violations and data flows.
 */
export const listServices = (): Call<Services> => ({ method: "GET", path: "/api/v1/services", answer: schema.services });

/**
 * Calls one operation of a service, and answers its response.
 *
 * An operation that `moves` is called by hand: it needs the controls of the cell, and the mode `programming`. What refuses it
 * there is an error of the response, as on the WebSocket of the controls. One that is `safe` ends what a person moves there while
 * they hold a button. An operation that the service does not have is answered `unavailable`. The response is waited for 5 s:
 * after that the call is abandoned, and what it began may go on.
 *
 * service: Of a service, as in `svc.KEY` (services.json).
 *
 * raceControl: The secret of the message `taken` (control_message.json): who sends the request has the controls of the cell. 409
 * (`leased`): they have them no more.
 *
 * 400: The body is no JSON or out of its limits (`json`, `too_deep`, `out_of_range`).
 *
 * 404: There is nothing of this name or number (`not_found`).
 *
 * 409: `leased`: the operation moves, and who asks has not the controls of the cell, or it changes something, and somebody else
 * has them; `stopped`: one that is called while a button is held, which was held when the cell was stopped or got another mode,
 * or a request stopped the service.
 *
 * 422: The body does not fit its schema.
 *
 * 429: 4 calls of the account wait already (`too_many`); none of them waits for more than 5 s. Without accounts, 16 may. What
 * reads, what is `safe`, and all else is counted by itself.
 *
 * 503: The service has not responded within 5 s, or 16 calls by requests wait already (`unavailable`, with Retry-After). What
 * reads, what is `safe`, and all else is counted by itself.
 */
export const callService = (
  service: string,
  body: Body<ServiceCall>,
  options: { readonly raceControl?: string | undefined } = {},
): Call<ServiceResponse> => ({
  method: "POST",
  path: `/api/v1/services/${segment(service)}/calls`,
  headers: { "Race-Control": options.raceControl },
  body,
  answer: schema.serviceResponse,
});
