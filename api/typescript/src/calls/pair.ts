// Routes of api/openapi.yaml: pair. Made by api/python/generate/main.py. The request filter may also refuse each.
import { type Body, type Call } from "../call.js";
import type { Pair, PairAnswer } from "../generated/messages.js";
import * as schema from "../generated/validators.js";

/**
 * A token for a code (POST /api/v1/pairings). It stands at the cell, as an account of the group `local`.
 *
 * A code that is none, was used or is too old is answered alike, and so is one whose maker has logged out, has another role or is
 * gone. Attempts count as logins of this address do. The token is listed and revoked as others of the account.
 *
 * 400: The body is no JSON or out of its limits (`json`, `too_deep`, `out_of_range`).
 *
 * 401: The code brings nothing (`pairing`).
 *
 * 409: The server has no accounts: who reaches it, on its machine alone, needs no code (`no_accounts`).
 *
 * 413: The account has 100 tokens that are no logins (`too_large`).
 *
 * 422: Every violation of the request, or of the document that it brings or names.
 *
 * 429: Too many logins or codes have failed, of this address or name (`attempts`); no password and no code was looked at.
 *
 * 500: What is stored is damaged (`corrupt`); the error names the part.
 *
 * 503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`): ask again.
 *
 * 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
 * interrupted. Ask again when it works.
 */
export const pair = (body: Body<Pair>): Call<PairAnswer> => ({
  method: "POST",
  path: "/api/v1/pair",
  body,
  answer: schema.pairAnswer,
});
