// What the stop asks the server of the page.
import type { Call } from "../../../api/typescript/src/call";
import { request } from "../../../api/typescript/src/request";
import type { Control } from "../../generated/messages";
import * as schema from "../../generated/stopValidators";

// With the validators of STOP, which come alone.
const kReset: Call<Control> = { method: "POST", path: "/api/v1/stop/reset", answer: schema.control };
const kControl: Call<Control> = { method: "GET", path: "/api/v1/control", answer: schema.control };

/** Motions may begin again. `fetcher`: of the account. Rejects with a RaceError: why the server refuses it. */
export const resetStop = (fetcher: typeof fetch): Promise<Control> => request({ origin: "", fetch: fetcher }, kReset);

/** Whether the cell is stopped. Rejects with a RaceError. */
export const getControl = (fetcher: typeof fetch, signal: AbortSignal): Promise<Control> => request({ origin: "", fetch: fetcher }, kControl, signal);
