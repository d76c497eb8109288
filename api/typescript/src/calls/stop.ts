// Routes of api/openapi.yaml: stop. Made by api/python/generate/main.py. The request filter may also refuse each.
import { type Call } from "../call.js";
import type { Control } from "../generated/messages.js";
import * as schema from "../generated/validators.js";

/**
 * Stops the cell, for everybody who asks: every safe operation of all services is called, all runs are ended, and nothing moves
 * until the reset. This is not a safety function. A body is not needed. A thread of its own serves the same on a port of its own
 * (control.json, `stop_ports`), which reads a header of 1 KiB and nothing else, and answers `{"stopped": true}`.
 */
export const stopCell = (): Call<Control> => ({ method: "POST", path: "/api/v1/stop", answer: schema.control });

/**
 * Motions may begin again; none does by that. Runs that the stop has ended are over. Of a cell that is not stopped nothing
 * happens.
 */
export const resetStop = (): Call<Control> => ({ method: "POST", path: "/api/v1/stop/reset", answer: schema.control });
