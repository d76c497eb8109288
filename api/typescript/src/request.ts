// Requests: one is sent, and its answer is checked against its schema.
import { RawJson, targetOf, type Call } from "./call.js";
import { check, SchemaError } from "./check.js";
import { failure, fetchFailure, isTimeout, kProtocol, RaceError, refusal } from "./errors.js";
import { writeExact } from "./exact.js";

/** Who sends requests where. */
export interface Transport {
  /** `http://127.0.0.1:8080`; empty: the server that the page came from. */
  readonly origin: string;
  readonly fetch: typeof fetch;
}

/** The server's largest answers have 16 MiB; of one that says that it has more [bytes], nothing is read. */
export const kMaxAnswer = 64 * 1024 * 1024;

function initOf({ method, headers = {}, body }: Call<unknown>): RequestInit {
  const sent = new Headers();
  for (const [name, value] of Object.entries(headers)) if (value !== undefined) sent.set(name, String(value));
  if (body === undefined) return { method, headers: sent };
  sent.set("content-type", "application/json");
  return { method, headers: sent, body: body instanceof RawJson ? body.content : writeExact(body) };
}

/** [s], of an answer that has it. */
function retryAfter(answer: Response): number | undefined {
  const seconds = Number(answer.headers.get("retry-after") ?? NaN);
  return Number.isFinite(seconds) ? seconds : undefined;
}

/** The text of the answer, if the server has done what it was asked for. */
async function acceptedText({ origin, fetch: fetcher }: Transport, call: Call<unknown>, signal?: AbortSignal): Promise<string> {
  const init = initOf(call);
  const where = origin === "" ? "the server" : origin;
  try {
    const answer = await fetcher(origin + targetOf(call), signal === undefined ? init : { ...init, signal });
    if (Number(answer.headers.get("content-length") ?? 0) > kMaxAnswer) throw failure(kProtocol, `the answer has more than ${kMaxAnswer} bytes`);
    const text = await answer.text();
    if (answer.status === 304) throw new RaceError(304, [{ path: "", code: "not_modified", message: "the client has this revision" }]);
    if (!answer.ok) throw refusal(answer.status, text, retryAfter(answer));
    return text;
  } catch (error) {
    // What its caller has aborted fails for their reason.
    if (signal?.aborted === true && !isTimeout(signal.reason)) throw signal.reason as unknown;
    throw fetchFailure(error, where);
  }
}

/** The answer of this text. */
function answerOf<Answer>({ method, path, answer }: Call<Answer>, text: string): Answer {
  if (answer === "text") return text as Answer;
  let value: unknown;
  try {
    value = JSON.parse(text);
  } catch {
    throw failure(kProtocol, `${method} ${path} was not answered with JSON: not a server of RACE?`);
  }
  try {
    return check(answer, value);
  } catch (error) {
    throw error instanceof SchemaError ? failure(kProtocol, `${method} ${path} was answered otherwise than its schema says: ${error.message}`) : error;
  }
}

/**
 * The answer to a request. `signal` limits its time, or aborts it. Rejects with a RaceError: refused, or no answer; with a TypeError if it
 * cannot be sent; and when it is aborted, with the reason of that.
 */
export async function request<Answer>(transport: Transport, call: Call<Answer>, signal?: AbortSignal): Promise<Answer> {
  return answerOf(call, await acceptedText(transport, call, signal));
}

/** The same as it was sent, for one who reads its numbers as they were written (exact.ts). */
export async function requestText(transport: Transport, call: Call<unknown>, signal?: AbortSignal): Promise<string> {
  const text = await acceptedText(transport, call, signal);
  answerOf(call, text);
  return text;
}

/** A `fetch` that has the token of an account with each request, if there is one. */
export const withToken = (fetcher: typeof fetch, token: () => string | undefined): typeof fetch => (input, init) => {
  const known = token();
  if (known === undefined) return fetcher(input, init);
  const headers = new Headers(init?.headers);
  headers.set("authorization", `Bearer ${known}`);
  return fetcher(input, { ...init, headers });
};
