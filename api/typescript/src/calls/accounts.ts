// Routes of api/openapi.yaml: accounts. Made by api/python/generate/main.py. The request filter may also refuse each.
import { segment, type Body, type Call } from "../call.js";
import type { Account, AccountChange, AccountCreate, AccountRemoved, AccountTokens, Accounts, TokenCreate, TokenCreated, TokenRemoved } from "../generated/messages.js";
import * as schema from "../generated/validators.js";

/**
 * The accounts, by name.
 */
export const listAccounts = (): Call<Accounts> => ({ method: "GET", path: "/api/v1/accounts", answer: schema.accounts });

/**
 * Makes an account. The first is an admin's, with a password; from then on everybody needs one.
 *
 * 400: The body is no JSON or out of its limits (`json`, `too_deep`), or the role, password or component group can be none
 * (`out_of_range`).
 *
 * 409: There is an account of this name (`conflict`).
 *
 * 413: There are 200 accounts (`too_large`).
 *
 * 422: The request does not fit its schema. `name`: that can be none; `missing`: a process has no group; `not_accepted`: another
 * role has groups, a process has a password, or the first account is no admin's with a password.
 *
 * 500: What is stored is damaged (`corrupt`); the error names the part.
 *
 * 503: Eight passwords wait already, or there is no memory for one (`unavailable`): ask again. Or the accounts cannot be written
 * (`io`).
 *
 * 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
 * interrupted. Ask again when it works.
 */
export const createAccount = (body: Body<AccountCreate>): Call<Account> => ({
  method: "POST",
  path: "/api/v1/accounts",
  body,
  answer: schema.account,
});

/**
 * Changes role, component groups or password of an account; what is absent stays.
 *
 * A new password ends all its tokens. Its WebSockets end soon after if it has another role or other groups now, or their token
 * has ended. A person does not become a process, nor a process a person.
 *
 * 400: The body is no JSON or out of its limits (`json`, `too_deep`), or the role, password or component group can be none
 * (`out_of_range`).
 *
 * 404: There is no such account (`not_found`).
 *
 * 409: `conflict`: no admin with a password would be left.
 *
 * 422: The request does not fit its schema. `missing`: a process would have no group; `not_accepted`: another role would have
 * groups, a process a password, or a person would become a process or a process a person.
 *
 * 500: What is stored is damaged (`corrupt`); the error names the part.
 *
 * 503: Eight passwords wait already, or there is no memory for one (`unavailable`): ask again. Or the accounts cannot be written
 * (`io`).
 *
 * 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
 * interrupted. Ask again when it works.
 */
export const changeAccount = (name: string, body: Body<AccountChange>): Call<Account> => ({
  method: "PUT",
  path: `/api/v1/accounts/${segment(name)}`,
  body,
  answer: schema.account,
});

/**
 * Removes an account with all its tokens. What it has made stays; its WebSockets end soon after.
 *
 * 404: There is nothing of this name or number (`not_found`).
 *
 * 409: `conflict`: no admin with a password would be left.
 *
 * 500: What is stored is damaged (`corrupt`); the error names the part.
 *
 * 503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`): ask again.
 *
 * 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
 * interrupted. Ask again when it works.
 */
export const deleteAccount = (name: string): Call<AccountRemoved> => ({
  method: "DELETE",
  path: `/api/v1/accounts/${segment(name)}`,
  answer: schema.accountRemoved,
});

/**
 * The tokens of an account that have not expired, the oldest first. The secrets are not kept.
 *
 * 404: There is nothing of this name or number (`not_found`).
 */
export const listTokens = (name: string): Call<AccountTokens> => ({
  method: "GET",
  path: `/api/v1/accounts/${segment(name)}/tokens`,
  answer: schema.accountTokens,
});

/**
 * Makes a token of an account, for a program or a process.
 *
 * The answer alone has the secret. The token itself has no address; the list of tokens has its label and digest.
 *
 * 400: The body is no JSON or out of its limits (`json`, `too_deep`), or `days` or `role` is out of its range (`out_of_range`).
 *
 * 404: There is nothing of this name or number (`not_found`).
 *
 * 413: The label has more than 100 characters, or the account has 100 tokens that are no logins (`too_large`).
 *
 * 422: The request does not fit its schema; `not_accepted`: the label is `login`, the account may do less than `role`, or a
 * process would have a role or be `local`.
 *
 * 500: What is stored is damaged (`corrupt`); the error names the part.
 *
 * 503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`): ask again.
 *
 * 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
 * interrupted. Ask again when it works.
 */
export const createToken = (name: string, body: Body<TokenCreate>): Call<TokenCreated> => ({
  method: "POST",
  path: `/api/v1/accounts/${segment(name)}/tokens`,
  body,
  answer: schema.tokenCreated,
});

/**
 * Ends a token of an account. WebSockets that were opened by it end soon after.
 *
 * 404: There is no such account, or it has no such token (`not_found`).
 *
 * 500: What is stored is damaged (`corrupt`); the error names the part.
 *
 * 503: The store cannot be read or written (`io`), or others change the same document and take long (`unavailable`): ask again.
 *
 * 507: The disk is full, fails or hangs (`storage`). Nothing is changed, or it is not known yet what is stored: then the run is
 * interrupted. Ask again when it works.
 */
export const revokeToken = (name: string, digest: string): Call<TokenRemoved> => ({
  method: "DELETE",
  path: `/api/v1/accounts/${segment(name)}/tokens/${segment(digest)}`,
  answer: schema.tokenRemoved,
});
