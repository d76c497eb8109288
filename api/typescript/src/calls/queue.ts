// Routes of api/openapi.yaml: queue. Made by api/python/generate/main.py. The request filter may also refuse each.
import { segment, type Body, type Call } from "../call.js";
import type { Queue, QueuedRun, QueuedRunCreate } from "../generated/messages.js";
import * as schema from "../generated/validators.js";

/**
 * The runs that wait their turn, and those before them, in order; at most 100 of an answer.
 *
 * after: Only those with a larger id.
 *
 * 400: A parameter is out of its range (`out_of_range`).
 */
export const listQueue = (
  options: { readonly after?: number | undefined; readonly limit?: number | undefined } = {},
): Call<Queue> => ({
  method: "GET",
  path: "/api/v1/queue",
  query: { after: options.after, limit: options.limit },
  answer: schema.queue,
});

/**
 * Queues a run. It begins when all before it are over; at once, if there are none.
 *
 * The document and the arguments are checked now, and this revision is what is executed. It begins as its maker would begin it
 * then (POST cores, then POST start): they must still be who they were, with the same token, and have the controls of the cell if
 * they had them now (Race-Control). If that is not so, or it may not begin for another reason, it is refused, and the queue
 * pauses. It also pauses after a run that was aborted, after a fault unless `on_fault` is go_on, and instead of beginning a run
 * while the cell is stopped; the reset of the stop begins nothing. A run that is paused or interrupted is not over. The queue is
 * empty after a restart of the server, and after a backup is restored all that waits is cancelled.
 *
 * idempotencyKey: Chosen by the client, another one for each request. A request that is sent again with its key is answered as
 * the first time, with `Idempotency-Replayed: true`, and creates nothing more: also if the first answer was lost. Refused
 * requests may be sent again. Another request with the key is refused with 422, one that comes while the first is under way with
 * 409 (`conflict`). The last 1000 answers are kept, while the server runs.
 *
 * raceControl: The secret of the message `taken` (control_message.json): who sends the request has the controls of the cell. 409
 * (`leased`): they have them no more.
 *
 * 400: The body is no JSON or out of its limits (`json`, `too_deep`), or `on_fault` is none of its values (`out_of_range`).
 *
 * 404: No such document (`not_found`).
 *
 * 409: 100 runs wait already, or a backup was restored meanwhile (`conflict`); or who sends it has the controls no more
 * (`leased`).
 *
 * 413: `too_large`: the arguments or the name.
 *
 * 422: The request does not fit its schema, an argument does not fit, or the document has violations.
 *
 * 500: What is stored is damaged (`corrupt`); the error names the part.
 *
 * 503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`): ask again.
 *
 * 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
 * interrupted. Ask again when it works.
 */
export const queueRun = (
  body: Body<QueuedRunCreate>,
  options: { readonly idempotencyKey?: string | undefined; readonly raceControl?: string | undefined } = {},
): Call<QueuedRun> => ({
  method: "POST",
  path: "/api/v1/queue",
  headers: { "Idempotency-Key": options.idempotencyKey, "Race-Control": options.raceControl },
  body,
  answer: schema.queuedRun,
});

/**
 * The queue goes on after a pause. The next run begins as whoever queued it.
 *
 * 409: The cell is stopped (`stopped`): reset it first.
 */
export const resumeQueue = (): Call<Queue> => ({ method: "POST", path: "/api/v1/queue/resume", answer: schema.queue });

/**
 * One queued run.
 *
 * 404: There is nothing of this name or number (`not_found`).
 */
export const getQueuedRun = (id: string): Call<QueuedRun> => ({
  method: "GET",
  path: `/api/v1/queue/${segment(id)}`,
  answer: schema.queuedRun,
});

/**
 * Cancels a run that waits. One that runs is stopped at its core.
 *
 * 404: There is nothing of this name or number (`not_found`).
 *
 * 409: It does not wait any more (`conflict`).
 */
export const cancelQueuedRun = (id: string): Call<QueuedRun> => ({
  method: "DELETE",
  path: `/api/v1/queue/${segment(id)}`,
  answer: schema.queuedRun,
});
