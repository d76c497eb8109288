// Routes of api/openapi.yaml: cores. Made by api/python/generate/main.py. The request filter may also refuse each.
import { segment, type Body, type Call } from "../call.js";
import type { Breakpoints, Core, CoreConfirmEdit, CoreCreate, CoreLive, CoreLoad, CoreResume, CoreStart, CoreState, Cores, Derivations, Force, Journal, Native, Past, Script, StepRequest, Why } from "../generated/messages.js";
import * as schema from "../generated/validators.js";

/**
 * The cores, running or not.
 */
export const listCores = (): Call<Cores> => ({ method: "GET", path: "/api/v1/cores", answer: schema.cores });

/**
 * Makes a core of a document and arguments. It waits to be started.
 *
 * idempotencyKey: Chosen by the client, another one for each request. A request that is sent again with its key is answered as
 * the first time, with `Idempotency-Replayed: true`, and creates nothing more: also if the first answer was lost. Refused
 * requests may be sent again. Another request with the key is refused with 422, one that comes while the first is under way with
 * 409 (`conflict`). The last 1000 answers are kept, while the server runs.
 *
 * 400: The body is no JSON or out of its limits (`json`, `too_deep`, `out_of_range`).
 *
 * 404: No such document (`not_found`).
 *
 * 409: There are 128 cores already, and no run of them is over, or a backup is being restored (`conflict`).
 *
 * 422: The request does not fit its schema, an argument does not fit, or the document has violations.
 *
 * 500: What is stored is damaged (`corrupt`); the error names the part.
 *
 * 503: The core is in a long macro step, or replays take long (`unavailable`): ask again. Or the store cannot be read or written
 * (`io`).
 *
 * 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
 * interrupted. Ask again when it works.
 */
export const createCore = (
  body: Body<CoreCreate>,
  options: { readonly idempotencyKey?: string | undefined } = {},
): Call<Core> => ({
  method: "POST",
  path: "/api/v1/cores",
  headers: { "Idempotency-Key": options.idempotencyKey },
  body,
  answer: schema.core,
});

/**
 * One core.
 *
 * id: Of a core.
 *
 * 404: There is nothing of this name or number (`not_found`).
 */
export const getCore = (id: string): Call<Core> => ({ method: "GET", path: `/api/v1/cores/${segment(id)}`, answer: schema.core });

/**
 * Removes a core; one that runs is stopped first.
 *
 * id: Of a core.
 *
 * 404: There is nothing of this name or number (`not_found`).
 *
 * 409: It is being loaded or removed (`conflict`).
 *
 * 500: What is stored is damaged (`corrupt`); the error names the part.
 *
 * 503: The core is in a long macro step, or replays take long (`unavailable`): ask again. Or the store cannot be read or written
 * (`io`).
 *
 * 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
 * interrupted. Ask again when it works.
 */
export const deleteCore = (id: string): Call<Core> => ({
  method: "DELETE",
  path: `/api/v1/cores/${segment(id)}`,
  answer: schema.core,
});

/**
 * Loads another document, its last revision, or other arguments into a core that has not begun. It waits to be started, as
 * before.
 *
 * id: Of a core.
 *
 * 400: The body is no JSON or out of its limits (`json`, `too_deep`, `out_of_range`).
 *
 * 404: No such core or document.
 *
 * 409: Its run has begun, make another core; or it is being loaded or removed, or a backup is being restored (`conflict`).
 *
 * 422: An argument does not fit, or the document has violations; nothing is changed.
 *
 * 500: What is stored is damaged (`corrupt`); the error names the part.
 *
 * 503: The core is in a long macro step, or replays take long (`unavailable`): ask again. Or the store cannot be read or written
 * (`io`).
 *
 * 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
 * interrupted. Ask again when it works.
 */
export const loadCore = (id: string, body: Body<CoreLoad>): Call<Core> => ({
  method: "POST",
  path: `/api/v1/cores/${segment(id)}/load`,
  body,
  answer: schema.core,
});

/**
 * Starts a core that waits; the first macro step activates the root. With arguments, these take the place of those that it was
 * created with.
 *
 * id: Of a core.
 *
 * raceControl: The secret of the message `taken` (control_message.json): who sends the request has the controls of the cell. 409
 * (`leased`): they have them no more.
 *
 * 400: The body is no JSON or out of its limits (`json`, `too_deep`, `out_of_range`).
 *
 * 404: There is nothing of this name or number (`not_found`).
 *
 * 409: It was started before; or, as of resumeCore, it may not move.
 *
 * 422: An argument does not fit, or the body is none; nothing is changed.
 *
 * 500: What is stored is damaged (`corrupt`); the error names the part.
 *
 * 503: The core is in a long macro step, or replays take long (`unavailable`): ask again. Or the store cannot be read or written
 * (`io`).
 *
 * 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
 * interrupted. Ask again when it works.
 */
export const startCore = (
  id: string,
  body?: Body<CoreStart>,
  options: { readonly raceControl?: string | undefined } = {},
): Call<Core> => ({
  method: "POST",
  path: `/api/v1/cores/${segment(id)}/start`,
  headers: { "Race-Control": options.raceControl },
  body,
  answer: schema.core,
});

/**
 * Holds a core between macro steps, also before its start. Inputs go on waiting.
 *
 * id: Of a core.
 *
 * 404: There is nothing of this name or number (`not_found`).
 *
 * 409: The run is over (`conflict`).
 *
 * 500: What is stored is damaged (`corrupt`); the error names the part.
 *
 * 503: The core is in a long macro step, or replays take long (`unavailable`): ask again. Or the store cannot be read or written
 * (`io`).
 *
 * 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
 * interrupted. Ask again when it works.
 */
export const pauseCore = (id: string): Call<Core> => ({
  method: "POST",
  path: `/api/v1/cores/${segment(id)}/pause`,
  answer: schema.core,
});

/**
 * Lets a paused or interrupted core go on. 409 also: `stopped`: the cell is; `leased`: somebody else has the controls of the
 * cell; `conflict`: the run needs who begins it at the controls.
 *
 * id: Of a core.
 *
 * raceControl: The secret of the message `taken` (control_message.json): who sends the request has the controls of the cell. 409
 * (`leased`): they have them no more.
 *
 * 400: The body is no JSON or out of its limits (`json`, `too_deep`, `out_of_range`).
 *
 * 404: There is nothing of this name or number (`not_found`).
 *
 * 409: The run is over (`conflict`).
 *
 * 422: The body does not fit its schema.
 *
 * 500: What is stored is damaged (`corrupt`); the error names the part.
 *
 * 503: The core is in a long macro step, or replays take long (`unavailable`): ask again. Or the store cannot be read or written
 * (`io`).
 *
 * 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
 * interrupted. Ask again when it works.
 */
export const resumeCore = (
  id: string,
  body?: Body<CoreResume>,
  options: { readonly raceControl?: string | undefined } = {},
): Call<Core> => ({
  method: "POST",
  path: `/api/v1/cores/${segment(id)}/resume`,
  headers: { "Race-Control": options.raceControl },
  body,
  answer: schema.core,
});

/**
 * Aborts a run between macro steps. No exit function runs; the safe operations of the services it called are invoked.
 *
 * id: Of a core.
 *
 * 404: There is nothing of this name or number (`not_found`).
 *
 * 409: It is over or was not started.
 *
 * 500: What is stored is damaged (`corrupt`); the error names the part.
 *
 * 503: The core is in a long macro step, or replays take long (`unavailable`): ask again. Or the store cannot be read or written
 * (`io`).
 *
 * 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
 * interrupted. Ask again when it works.
 */
export const stopCore = (id: string): Call<Core> => ({
  method: "POST",
  path: `/api/v1/cores/${segment(id)}/stop`,
  answer: schema.core,
});

/**
 * Lets a paused core do one micro step, one macro step, or go on until what a breakpoint could name. It is paused afterwards, and
 * while its step waits for an input; then another step may take its place.
 *
 * id: Of a core.
 *
 * raceControl: The secret of the message `taken` (control_message.json): who sends the request has the controls of the cell. 409
 * (`leased`): they have them no more.
 *
 * 400: The body is no JSON or out of its limits (`json`, `too_deep`, `out_of_range`).
 *
 * 404: No such state, port, action or operation.
 *
 * 409: It is not paused; or, as of resumeCore, it may not move.
 *
 * 422: The request is no step; every violation.
 *
 * 500: What is stored is damaged (`corrupt`); the error names the part.
 *
 * 503: The core is in a long macro step, or replays take long (`unavailable`): ask again. Or the store cannot be read or written
 * (`io`).
 *
 * 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
 * interrupted. Ask again when it works.
 */
export const stepCore = (
  id: string,
  body: Body<StepRequest>,
  options: { readonly raceControl?: string | undefined } = {},
): Call<Core> => ({
  method: "POST",
  path: `/api/v1/cores/${segment(id)}/step`,
  headers: { "Race-Control": options.raceControl },
  body,
  answer: schema.core,
});

/**
 * An edit that waits for it may reach the run (core.json, `unconfirmed`); only who has the controls of the cell says so.
 *
 * id: Of a core.
 *
 * raceControl: The secret of the message `taken` (control_message.json): who sends the request has the controls of the cell. 409
 * (`leased`): they have them no more.
 *
 * 400: The body is no JSON or out of its limits (`json`, `too_deep`, `out_of_range`).
 *
 * 404: There is nothing of this name or number (`not_found`).
 *
 * 409: `conflict`: no edit to this revision waits; `leased`: who asks has not the controls.
 *
 * 422: The body does not fit its schema.
 *
 * 500: What is stored is damaged (`corrupt`); the error names the part.
 *
 * 503: The core is in a long macro step, or replays take long (`unavailable`): ask again. Or the store cannot be read or written
 * (`io`).
 */
export const confirmCoreEdit = (
  id: string,
  body: Body<CoreConfirmEdit>,
  options: { readonly raceControl?: string | undefined } = {},
): Call<Core> => ({
  method: "POST",
  path: `/api/v1/cores/${segment(id)}/confirm_edit`,
  headers: { "Race-Control": options.raceControl },
  body,
  answer: schema.core,
});

/**
 * Sets where the core is paused, in place of what the same person has set before. Breakpoints end the step under way, too.
 *
 * id: Of a core.
 *
 * author: Who sets them: those of others stay. Without it they take the place of all.
 *
 * 400: The body is no JSON or out of its limits (`json`, `too_deep`, `out_of_range`).
 *
 * 404: No such state, port, action or operation.
 *
 * 409: The run is over (`conflict`).
 *
 * 413: `too_large`: there are more than 100, with those of others; a condition has more than 500 characters, or the author more
 * than 100.
 *
 * 422: Every violation of the request, or of the document that it brings or names.
 *
 * 500: What is stored is damaged (`corrupt`); the error names the part.
 *
 * 503: The core is in a long macro step, or replays take long (`unavailable`): ask again. Or the store cannot be read or written
 * (`io`).
 *
 * 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
 * interrupted. Ask again when it works.
 */
export const setBreakpoints = (
  id: string,
  body: Body<Breakpoints>,
  options: { readonly author?: string | undefined } = {},
): Call<Core> => ({
  method: "PUT",
  path: `/api/v1/cores/${segment(id)}/breakpoints`,
  query: { author: options.author },
  body,
  answer: schema.core,
});

/**
 * Whether the core follows the edits of its document. A running core gets each revision without violations between macro steps,
 * as soon as everything active has a place in it; until then `waiting_edit` says what it waits for.
 *
 * id: Of a core.
 *
 * 400: The body is no JSON or out of its limits (`json`, `too_deep`, `out_of_range`).
 *
 * 404: There is nothing of this name or number (`not_found`).
 *
 * 409: The run is over (`conflict`).
 *
 * 422: Every violation of the request, or of the document that it brings or names.
 *
 * 500: What is stored is damaged (`corrupt`); the error names the part.
 *
 * 503: The core is in a long macro step, or replays take long (`unavailable`): ask again. Or the store cannot be read or written
 * (`io`).
 *
 * 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
 * interrupted. Ask again when it works.
 */
export const setCoreLive = (id: string, body: Body<CoreLive>): Call<Core> => ({
  method: "PUT",
  path: `/api/v1/cores/${segment(id)}/live`,
  body,
  answer: schema.core,
});

/**
 * Sets a parameter, result or variable of a running core, or takes a port of an active state, in a macro step of its own. A
 * paused core stays paused after it. As the run may move by that, who has the controls of the cell does it, if anybody has them.
 *
 * id: Of a core.
 *
 * raceControl: The secret of the message `taken` (control_message.json): who sends the request has the controls of the cell. 409
 * (`leased`): they have them no more.
 *
 * 400: The body is no JSON or out of its limits (`json`, `too_deep`, `out_of_range`).
 *
 * 404: No such core, state, value or port.
 *
 * 409: It is not running, is paused in a macro step, or the state of the port is not active. `leased`: somebody else has the
 * controls of the cell; `conflict`: nobody has, and the run needs who began it, or has moved something at a server with accounts.
 *
 * 413: `too_large`: the value is beyond the budget of the run.
 *
 * 422: Every violation of the request, or of the document that it brings or names.
 *
 * 500: What is stored is damaged (`corrupt`); the error names the part.
 *
 * 503: The core is in a long macro step, or replays take long (`unavailable`): ask again. Or the store cannot be read or written
 * (`io`).
 *
 * 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
 * interrupted. Ask again when it works.
 */
export const forceCore = (
  id: string,
  body: Body<Force>,
  options: { readonly raceControl?: string | undefined } = {},
): Call<Core> => ({
  method: "POST",
  path: `/api/v1/cores/${segment(id)}/force`,
  headers: { "Race-Control": options.raceControl },
  body,
  answer: schema.core,
});

/**
 * The native model that this core executes.
 *
 * id: Of a core.
 *
 * 404: There is nothing of this name or number (`not_found`).
 *
 * 500: What is stored is damaged (`corrupt`); the error names the part.
 *
 * 503: The core is in a long macro step, or replays take long (`unavailable`): ask again. Or the store cannot be read or written
 * (`io`).
 *
 * 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
 * interrupted. Ask again when it works.
 */
export const getCoreNative = (id: string): Call<Native> => ({
  method: "GET",
  path: `/api/v1/cores/${segment(id)}/native`,
  answer: schema.native,
});

/**
 * What is active, and the values, after the last step.
 *
 * id: Of a core.
 *
 * 404: There is nothing of this name or number (`not_found`).
 *
 * 500: What is stored is damaged (`corrupt`); the error names the part.
 *
 * 503: The core is in a long macro step, or replays take long (`unavailable`): ask again. Or the store cannot be read or written
 * (`io`).
 *
 * 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
 * interrupted. Ask again when it works.
 */
export const getCoreState = (id: string): Call<CoreState> => ({
  method: "GET",
  path: `/api/v1/cores/${segment(id)}/state`,
  answer: schema.coreState,
});

/**
 * The derivations of macro steps, recomputed from the journal; at most 100 steps of an answer.
 *
 * id: Of a core.
 *
 * from: First macro step; else the last one.
 *
 * to: Last macro step; else `from`.
 *
 * 400: A parameter is out of its range (`out_of_range`).
 *
 * 404: There is nothing of this name or number (`not_found`).
 *
 * 500: What is stored is damaged (`corrupt`); the error names the part.
 *
 * 503: The core is in a long macro step, or replays take long (`unavailable`): ask again. Or the store cannot be read or written
 * (`io`).
 *
 * 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
 * interrupted. Ask again when it works.
 */
export const getDerivations = (
  id: string,
  options: { readonly from?: number | undefined; readonly to?: number | undefined } = {},
): Call<Derivations> => ({
  method: "GET",
  path: `/api/v1/cores/${segment(id)}/derivations`,
  query: { from: options.from, to: options.to },
  answer: schema.derivations,
});

/**
 * The run so far as a script; with the model of `native` (as a document), `race derive` gives this run's derivations.
 *
 * id: Of a core.
 *
 * 404: There is nothing of this name or number (`not_found`).
 *
 * 413: `too_large`: the answer would have more than 16 MiB (16777216 bytes). Ask for parts of it, /api/v1/runs/{run}/derivations,
 * or read the run where it is stored: `race replay RUN --data DIR`.
 *
 * 500: What is stored is damaged (`corrupt`); the error names the part.
 *
 * 503: The core is in a long macro step, or replays take long (`unavailable`): ask again. Or the store cannot be read or written
 * (`io`).
 *
 * 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
 * interrupted. Ask again when it works.
 */
export const getCoreScript = (id: string): Call<Script> => ({
  method: "GET",
  path: `/api/v1/cores/${segment(id)}/script`,
  answer: schema.script,
});

/**
 * Header and inputs of the run, in order of delivery; the run is a function of these.
 *
 * id: Of a core.
 *
 * 404: There is nothing of this name or number (`not_found`).
 *
 * 413: `too_large`: the answer would have more than 16 MiB (16777216 bytes). Ask for parts of it, /api/v1/runs/{run}/derivations,
 * or read the run where it is stored: `race replay RUN --data DIR`.
 *
 * 500: What is stored is damaged (`corrupt`); the error names the part.
 *
 * 503: The core is in a long macro step, or replays take long (`unavailable`): ask again. Or the store cannot be read or written
 * (`io`).
 *
 * 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
 * interrupted. Ask again when it works.
 */
export const getCoreJournal = (id: string): Call<Journal> => ({
  method: "GET",
  path: `/api/v1/cores/${segment(id)}/journal`,
  answer: schema.journal,
});

/**
 * Why a port fired or does not fire, an action was executed or is not, or a parameter has its value.
 *
 * id: Of a core.
 *
 * port: A port, as Root/A.success; or `state` with one of `action` and `parameter`.
 *
 * state: The state of the action or parameter, as Root/A.
 *
 * action: Its number within the state, from 0.
 *
 * parameter: Its name.
 *
 * step: With `micro`: as things were in this macro step; else as they are now.
 *
 * micro: Before this micro step of it, and when the turn of what is asked about comes in it; those that the derivation of the
 * step lists.
 *
 * 400: A parameter is out of its range (`out_of_range`).
 *
 * 404: No such core, port, action or parameter.
 *
 * 409: `conflict`: more than one thing is asked about.
 *
 * 422: `missing`: what is asked about, or one of `step` and `micro`
 *
 * 500: What is stored is damaged (`corrupt`); the error names the part.
 *
 * 503: The core is in a long macro step, or replays take long (`unavailable`): ask again. Or the store cannot be read or written
 * (`io`).
 *
 * 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
 * interrupted. Ask again when it works.
 */
export const getWhy = (
  id: string,
  options: { readonly port?: string | undefined; readonly state?: string | undefined; readonly action?: number | undefined; readonly parameter?: string | undefined; readonly step?: number | undefined; readonly micro?: number | undefined } = {},
): Call<Why> => ({
  method: "GET",
  path: `/api/v1/cores/${segment(id)}/why`,
  query: { port: options.port, state: options.state, action: options.action, parameter: options.parameter, step: options.step, micro: options.micro },
  answer: schema.why,
});

/**
 * The run as it was at an earlier micro step, recomputed from the journal. Nothing of it is done again; robots and services stay
 * where they are.
 *
 * id: Of a core.
 *
 * step: A macro step that has begun.
 *
 * micro: After this many micro steps of it; absent, or more than it has: at its end.
 *
 * 400: A parameter is out of its range (`out_of_range`).
 *
 * 404: There is nothing of this name or number (`not_found`).
 *
 * 422: `missing`: the step
 *
 * 500: What is stored is damaged (`corrupt`); the error names the part.
 *
 * 503: The core is in a long macro step, or replays take long (`unavailable`): ask again. Or the store cannot be read or written
 * (`io`).
 *
 * 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
 * interrupted. Ask again when it works.
 */
export const getPast = (id: string, options: { readonly step: number; readonly micro?: number | undefined }): Call<Past> => ({
  method: "GET",
  path: `/api/v1/cores/${segment(id)}/past`,
  query: { step: options.step, micro: options.micro },
  answer: schema.past,
});
