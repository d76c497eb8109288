// The connection of services to the server, which is made again when it is lost.
import { failure, fetchFailure, kCertificate, kConnection, kTimeout, RaceError, refusal } from "../errors.js";
import type { Hosted, Log } from "./hosted.js";
import { kOpenTimeout, Session, type ServiceSocket } from "./session.js";

const kPath = "/api/v1/components";
/** [ms] between attempts to connect; the last again and again. */
const kRetries = [100, 200, 500, 1000] as const;
/** [s] for a process that was there before to be missed. */
const kTakenTime = 10;

type RequestHeaders = Readonly<Record<string, string>>;

/** As WebSocket of the package `ws`, and of Node 22. */
export type ServiceSocketConstructor = new (address: string, options: { readonly headers: RequestHeaders }) => Pick<ServiceSocket, "send" | "close">;

export interface ServiceServer {
  /** http://HOST:PORT or https://HOST:PORT. */
  readonly origin: string;
  /** Of the process; read anew each time, as the server may have made it meanwhile. */
  readonly token: () => string | undefined;
  readonly webSocket: ServiceSocketConstructor;
  readonly show: Log;
}

/** Whether it may be otherwise soon: there is no server, or it has much to do. */
const passes = ({ code, status }: RaceError): boolean => code === kConnection || code === kTimeout || status === 503;

/** Another process has the services, perhaps one that has just ended. */
const isTaken = ({ errors }: RaceError): boolean => errors.some(({ message }) => message.endsWith("has a process already"));

/** Why a connection does not come about, which a WebSocket does not tell: the refusal of the server, or `error`. */
async function reasonOf(error: RaceError, origin: string, headers: RequestHeaders): Promise<RaceError> {
  if (error.code !== kConnection) return error;
  try {
    const response = await fetch(origin + kPath, { headers, signal: AbortSignal.timeout(kOpenTimeout * 1000) });
    const text = await response.text();
    return response.status === 401 || response.status === 403 ? refusal(response.status, text) : error;
  } catch (thrown) {
    const asked = fetchFailure(thrown, origin);
    return asked.code === kCertificate ? asked : failure(kConnection, `${origin} cannot be reached: ${error.message}`);
  }
}

/** One connection; why it has ended, and whether the server had welcomed the services. */
async function connectOnce(hosted: readonly Hosted[], server: ServiceServer, signal: AbortSignal): Promise<{ readonly error: RaceError; readonly wasWelcome: boolean }> {
  const token = server.token();
  const headers: RequestHeaders = token === undefined ? {} : { authorization: `Bearer ${token}` };
  const socket = new server.webSocket(server.origin.replace(/^http/, "ws") + kPath, { headers }) as ServiceSocket;
  const session = new Session(socket, hosted, server.show);
  try {
    return await session.run(signal);
  } catch (error) {
    if (!(error instanceof RaceError)) throw error;
    const { isWelcome: wasWelcome } = session;
    return { error: wasWelcome || signal.aborted ? error : await reasonOf(error, server.origin, headers), wasWelcome };
  }
}

/** Rests, or until the signal is aborted. */
const rest = (milliseconds: number, signal: AbortSignal): Promise<void> =>
  new Promise((resolve) => {
    const wake = () => {
      clearTimeout(timer);
      signal.removeEventListener("abort", wake);
      resolve();
    };
    const timer = setTimeout(wake, milliseconds);
    signal.addEventListener("abort", wake);
    if (signal.aborted) wake();
  });

/** It may be meanwhile, which a compiler does not see. */
const isAborted = (signal: AbortSignal): boolean => signal.aborted;

/** Offers services at a server until `signal` is aborted. Rejects: with a RaceError, the server refuses them; else there is no token. */
export async function keepConnected(hosted: readonly Hosted[], server: ServiceServer, signal: AbortSignal): Promise<void> {
  const keys = hosted.map(({ declaration }) => declaration.key).join(", ");
  let takenSince: number | undefined;
  for (let attempts = 0; !signal.aborted; attempts++) {
    const { error, wasWelcome } = await connectOnce(hosted, server, signal);
    if (isAborted(signal)) return;
    if (wasWelcome) [attempts, takenSince] = [0, undefined];
    const taken = !wasWelcome && isTaken(error);
    if (taken) takenSince ??= performance.now();
    const mayGo = taken && takenSince !== undefined && performance.now() < takenSince + kTakenTime * 1000;
    if (!passes(error) && !mayGo) throw error;
    if (wasWelcome || attempts === 0) server.show(`${keys}: ${error.message}`);
    await rest(kRetries[Math.min(attempts, kRetries.length - 1)] ?? 1000, signal);
  }
}
