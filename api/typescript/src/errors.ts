// The one error of the library, and how all that keeps an answer away becomes it.
import type { ServerError } from "./generated/messages.js";
import { isObject, type JsonValue } from "./json.js";

// Codes that are not the server's; all others are (api/openapi.yaml names them by route).
/** There is no connection, or it ended. */
export const kConnection = "connection";
/** No connection or no answer in time. */
export const kTimeout = "timeout";
/** The server is not known by its certificate; nothing was sent. A browser does not tell: there it is `connection`. */
export const kCertificate = "certificate";
/** What came is not what api/ promises. */
export const kProtocol = "protocol";

export interface ErrorDetails {
  /** There are more errors than the listed ones. */
  readonly moreErrors?: boolean;
  /** The request may have reached the server. */
  readonly isSent?: boolean;
  /** When the server may be asked again [s]. */
  readonly retryAfter?: number | undefined;
}

const textOf = ({ path, message }: ServerError): string => (path === "" ? message : `${path}: ${message}`);

/**
 * What was asked for is not done, or not known to be done.
 *
 * `status`: the HTTP status of the server's refusal; 0 if none came by HTTP. `errors`: each reason, with `path` (node, port or field;
 * empty: the whole), `code` and `message`, and for code text with `text`, `line` and `column`: at least one and at most 200. `code` and
 * `path` are those of the first, `message` is of all. A program branches on `code`: of the server, or one of those above.
 */
export class RaceError extends Error {
  readonly code: string;
  readonly path: string;
  /** There are more errors than the listed ones. */
  readonly moreErrors: boolean;
  /** The request may have been done all the same: it was sent, and no answer has come that can be read. */
  mayBeDone: boolean;
  /** When the server may be asked again [s], if it says so. */
  readonly retryAfter: number | undefined;

  constructor(
    readonly status: number,
    readonly errors: readonly ServerError[],
    { moreErrors = false, isSent = true, retryAfter }: ErrorDetails = {},
  ) {
    super(errors.map(textOf).join("; "));
    this.name = "RaceError";
    this.code = errors[0]?.code ?? kProtocol;
    this.path = errors[0]?.path ?? "";
    this.moreErrors = moreErrors;
    this.mayBeDone = isSent && status === 0 && this.code !== kCertificate;
    this.retryAfter = retryAfter;
  }
}

/** A service has answered a call with an error. `error` is the whole value, with at least `code`; the RSM says what else it has. */
export class ServiceError extends RaceError {
  constructor(
    readonly service: string,
    readonly operation: string,
    readonly error: JsonValue,
  ) {
    const { code, message } = isObject(error) ? error : { code: undefined, message: undefined };
    const known = typeof code === "string" ? code : "error";
    super(200, [{ path: `${service}.${operation}`, code: known, message: typeof message === "string" ? message : "" }]);
    this.name = "ServiceError";
    this.message = typeof message === "string" && message !== "" ? message : typeof code === "string" ? code : "the service answers an error";
  }
}

/** Whether the server has refused it: it has answered, and nothing was done, but what a service without a response in time (`unavailable`) has begun. */
export const isRefusal = (error: unknown): error is RaceError => error instanceof RaceError && error.status !== 0;

/** Whether no answer has come, as there is no server or no network. */
export const isUnanswered = (error: unknown): error is RaceError =>
  error instanceof RaceError && error.status === 0 && (error.code === kConnection || error.code === kTimeout || error.code === kCertificate);

/** An error that is not the server's. */
export const failure = (code: string, message: string, details: ErrorDetails = {}): RaceError => new RaceError(0, [{ path: "", code, message }], details);

function errorOf(value: JsonValue): ServerError {
  if (!isObject(value)) throw new TypeError("no error");
  const { path, code, message } = value;
  if (typeof path !== "string" || typeof code !== "string" || typeof message !== "string") throw new TypeError("no error");
  return { ...value, path, code, message };
}

/** The error of an answer with problem details (api/schemas/problem.json), or of one that should have them. */
export function refusal(status: number, text: string, retryAfter?: number): RaceError {
  try {
    const problem = JSON.parse(text) as JsonValue;
    if (!isObject(problem) || !Array.isArray(problem["errors"]) || problem["errors"].length === 0) throw new TypeError("no problem");
    const errors = (problem["errors"] as readonly JsonValue[]).map(errorOf);
    return new RaceError(status, errors, { moreErrors: problem["more_errors"] === true, retryAfter });
  } catch {
    return new RaceError(status, [{ path: "", code: kProtocol, message: `status ${status} without problem details: not a server of RACE?` }], { retryAfter });
  }
}

/** Of Node: the server was not reached. */
const kNotSent: readonly string[] = ["ECONNREFUSED", "ENOTFOUND", "EAI_AGAIN", "EHOSTUNREACH", "ENETUNREACH", "UND_ERR_CONNECT_TIMEOUT"];
/** Of Node: of certificates (OpenSSL's names of what is wrong with them). */
const kOfCertificates = /CERT|UNABLE_TO_VERIFY_LEAF_SIGNATURE|HOSTNAME_MISMATCH/;

/** Why a `fetch` of Node has failed; a browser does not tell. */
function causeOf(error: unknown): { readonly code: string; readonly message: string } {
  const cause: unknown = error instanceof Error ? error.cause : undefined;
  const code = cause instanceof Error && "code" in cause && typeof cause.code === "string" ? cause.code : "";
  return { code, message: cause instanceof Error && cause.message !== "" ? cause.message : code };
}

/** Whether a time limit has passed: that of an AbortSignal, or of the library. */
export const isTimeout = (error: unknown): boolean =>
  error instanceof RaceError ? error.status === 0 && error.code === kTimeout : error instanceof Error && error.name === "TimeoutError";

/** What a failed `fetch` becomes. `where`: the address of the server. */
export function fetchFailure(error: unknown, where: string): RaceError {
  if (isTimeout(error)) return failure(kTimeout, `${where} does not answer in time`);
  if (error instanceof RaceError) return error;
  const { code, message } = causeOf(error);
  if (kOfCertificates.test(code)) return failure(kCertificate, `${where} is not known by its certificate: ${message}`);
  if (code.startsWith("HPE_")) return failure(kProtocol, `${where} does not speak HTTP as a server of RACE does: ${message}`);
  const isSent = !kNotSent.includes(code);
  if (/^UND_ERR_.*TIMEOUT$/.test(code)) return failure(kTimeout, `${where} does not answer in time`, { isSent });
  return failure(kConnection, `${where} cannot be reached${message === "" ? "" : `: ${message}`}`, { isSent });
}
