// Routes of api/openapi.yaml: me. Made by api/python/generate/main.py. The request filter may also refuse each.
import { type Body, type Call } from "../call.js";
import type { Empty, Me, PasswordChange } from "../generated/messages.js";
import * as schema from "../generated/validators.js";

/**
 * Who asks, and whether the server has accounts. Also answered to who is not known.
 */
export const getMe = (): Call<Me> => ({ method: "GET", path: "/api/v1/me", answer: schema.me });

/**
 * Changes one's own password. All tokens of the account end, also that of the request.
 *
 * The old password is tried as by a login, and counts for the same limit: who has found a token does not find out the password.
 *
 * 400: The body is no JSON or out of its limits (`json`, `too_deep`), or the new password can be none (`out_of_range`).
 *
 * 403: `password`: the old password is another one; `rights`: a process has none.
 *
 * 404: Who asks has no account: the server has none (`not_found`).
 *
 * 422: Every violation of the request, or of the document that it brings or names.
 *
 * 429: Too many logins or codes have failed, of this address or name (`attempts`); no password and no code was looked at.
 *
 * 500: What is stored is damaged (`corrupt`); the error names the part.
 *
 * 503: Eight passwords wait already, or there is no memory for one (`unavailable`): ask again. Or the accounts cannot be written
 * (`io`).
 *
 * 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
 * interrupted. Ask again when it works.
 */
export const changePassword = (body: Body<PasswordChange>): Call<Empty> => ({
  method: "PUT",
  path: "/api/v1/me/password",
  body,
  answer: schema.empty,
});
