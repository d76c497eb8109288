// Routes of api/openapi.yaml: control. Made by api/python/generate/main.py. The request filter may also refuse each.
import { type Body, type Call } from "../call.js";
import type { Control, ControlAnswer, ControlMode } from "../generated/messages.js";
import * as schema from "../generated/validators.js";

/**
 * Whether the cell is stopped, what runs have reserved, and where a stop is served. Who is not known learns no names.
 */
export const getControl = (): Call<Control> => ({ method: "GET", path: "/api/v1/control", answer: schema.control });

/**
 * A person at the cell lets somebody take the controls from who has them (control.json, `request`), or not. What moved by them
 * stops. At a server with accounts, an account of the group `local` alone may answer; at one without, everybody on its machine.
 *
 * 400: The body is no JSON or out of its limits (`json`, `too_deep`, `out_of_range`).
 *
 * 404: Nobody asks with that, or no more.
 *
 * 422: The body does not fit its schema.
 */
export const answerControlRequest = (body: Body<ControlAnswer>): Call<Control> => ({
  method: "POST",
  path: "/api/v1/control/answer",
  body,
  answer: schema.control,
});

/**
 * Sets the mode of the cell. What moves stops, and runs that moved something, or are watched, are paused. It stays over a
 * restart.
 *
 * raceControl: The secret of the message `taken` (control_message.json): who sends the request has the controls of the cell. 409
 * (`leased`): they have them no more.
 *
 * 400: The body is no JSON or out of its limits (`json`, `too_deep`, `out_of_range`).
 *
 * 409: `leased`: who asks has not the controls of the cell.
 *
 * 422: The body does not fit its schema.
 */
export const setCellMode = (
  body: Body<ControlMode>,
  options: { readonly raceControl?: string | undefined } = {},
): Call<Control> => ({
  method: "PUT",
  path: "/api/v1/control/mode",
  headers: { "Race-Control": options.raceControl },
  body,
  answer: schema.control,
});
