// Routes of api/openapi.yaml: backups. Made by api/python/generate/main.py. The request filter may also refuse each.
import { segment, type Call } from "../call.js";
import type { Backup, Backups, Task } from "../generated/messages.js";
import * as schema from "../generated/validators.js";

/**
 * The backups that are whole, by time; also while another one is made.
 *
 * 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
 * interrupted. Ask again when it works.
 */
export const listBackups = (): Call<Backups> => ({ method: "GET", path: "/api/v1/backups", answer: schema.backups });

/**
 * Copies all that the server keeps, as it is now; runs go on meanwhile. At most 20 are kept.
 *
 * idempotencyKey: Chosen by the client, another one for each request. A request that is sent again with its key is answered as
 * the first time, with `Idempotency-Replayed: true`, and creates nothing more: also if the first answer was lost. Refused
 * requests may be sent again. Another request with the key is refused with 422, one that comes while the first is under way with
 * 409 (`conflict`). The last 1000 answers are kept, while the server runs.
 *
 * 409: There are 20 already, or the request of this Idempotency-Key is under way (`conflict`).
 *
 * 500: What is stored is damaged (`corrupt`); the error names the part.
 *
 * 503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`): ask again.
 *
 * 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
 * interrupted. Ask again when it works.
 */
export const createBackup = (options: { readonly idempotencyKey?: string | undefined } = {}): Call<Backup> => ({
  method: "POST",
  path: "/api/v1/backups",
  headers: { "Idempotency-Key": options.idempotencyKey },
  answer: schema.backup,
});

/**
 * As createBackup, but answered before it is done: getTask says what it comes to. The server works on 16 such requests at most
 * (503, `unavailable`).
 *
 * idempotencyKey: Chosen by the client, another one for each request. A request that is sent again with its key is answered as
 * the first time, with `Idempotency-Replayed: true`, and creates nothing more: also if the first answer was lost. Refused
 * requests may be sent again. Another request with the key is refused with 422, one that comes while the first is under way with
 * 409 (`conflict`). The last 1000 answers are kept, while the server runs.
 *
 * 409: There are 20 already, or the request of this Idempotency-Key is under way (`conflict`).
 *
 * 500: What is stored is damaged (`corrupt`); the error names the part.
 *
 * 503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`): ask again.
 *
 * 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
 * interrupted. Ask again when it works.
 */
export const createBackupTask = (options: { readonly idempotencyKey?: string | undefined } = {}): Call<Task> => ({
  method: "POST",
  path: "/api/v1/backups",
  headers: { "Idempotency-Key": options.idempotencyKey, "Prefer": "respond-async" },
  answer: schema.task,
});

/**
 * One backup.
 *
 * 404: There is nothing of this name or number (`not_found`).
 */
export const getBackup = (name: string): Call<Backup> => ({
  method: "GET",
  path: `/api/v1/backups/${segment(name)}`,
  answer: schema.backup,
});

/**
 * Removes a backup.
 *
 * 404: There is nothing of this name or number (`not_found`).
 *
 * 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
 * interrupted. Ask again when it works.
 */
export const deleteBackup = (name: string): Call<Backup> => ({
  method: "DELETE",
  path: `/api/v1/backups/${segment(name)}`,
  answer: schema.backup,
});

/**
 * Makes all that the server keeps what it was then. Cores are removed.
 *
 * 404: There is nothing of this name or number (`not_found`).
 *
 * 409: A run is not over (`conflict`).
 *
 * 422: A newer version of the program made it (`version`).
 *
 * 500: The backup is damaged (`corrupt`); nothing is changed.
 *
 * 503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`): ask again.
 *
 * 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
 * interrupted. Ask again when it works.
 */
export const restoreBackup = (name: string): Call<Backup> => ({
  method: "POST",
  path: `/api/v1/backups/${segment(name)}/restore`,
  answer: schema.backup,
});

/**
 * As restoreBackup, but answered before it is done: getTask says what it comes to. The server works on 16 such requests at most
 * (503, `unavailable`).
 *
 * 404: There is nothing of this name or number (`not_found`).
 *
 * 409: A run is not over (`conflict`).
 *
 * 422: A newer version of the program made it (`version`).
 *
 * 500: The backup is damaged (`corrupt`); nothing is changed.
 *
 * 503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`): ask again.
 *
 * 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
 * interrupted. Ask again when it works.
 */
export const restoreBackupTask = (name: string): Call<Task> => ({
  method: "POST",
  path: `/api/v1/backups/${segment(name)}/restore`,
  headers: { "Prefer": "respond-async" },
  answer: schema.task,
});
