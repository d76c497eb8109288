// The controls of the cell, from one page: taken when a person says so, held by a sign of life each tenth of a second, given back or lost.
import type { ControlMessage, ControlRequest } from "../../generated/messages";
import * as schema from "../../generated/validators";
import type { JsonValue } from "../json";
import { check, SchemaError } from "../messages/check";

export type LinkState =
  | { readonly kind: "none" }
  | { readonly kind: "taking" }
  /** A person at the cell is asked. `since`: [ms of `now`] */
  | { readonly kind: "asked"; readonly request: number; readonly since: number }
  | { readonly kind: "held"; readonly number: number; readonly secret: string; readonly since: number }
  | { readonly kind: "lost"; readonly why: string }
  | { readonly kind: "refused"; readonly why: string };

/** The part of a WebSocket that is used. */
export interface ControlSocket {
  readonly send: (text: string) => void;
  readonly close: () => void;
}

export interface SocketHandlers {
  readonly onOpen: () => void;
  readonly onText: (text: string) => void;
  /** Also if it never opened. */
  readonly onClose: () => void;
}

export interface LinkOptions {
  /** The handlers are called later, never by this call. */
  readonly open: (address: string, handlers: SocketHandlers) => ControlSocket;
  /** [ms], also while the device sleeps. */
  readonly now: () => number;
  /** Calls `act` each so many ms; the result ends that. */
  readonly every: (time: number, act: () => void) => () => void;
  readonly onChange: (state: LinkState) => void;
}

/** The response to a call is an error. */
export class CallError extends Error {
  constructor(
    readonly code: string,
    message: string,
  ) {
    super(message);
    this.name = "CallError";
  }
}

/** Share of the calls that the server lets wait: more mean that it does not answer, and what stops has the rest. */
const kUsual = 0.5;
/** Share of the time that the server expects between two signs of life. */
const kEarly = 0.8;

interface Pending {
  readonly resolve: (result: JsonValue) => void;
  readonly reject: (error: CallError) => void;
}

const fieldOf = (value: unknown, name: string): unknown => (typeof value === "object" && value !== null ? (value as Readonly<Record<string, unknown>>)[name] : undefined);

function callError(error: unknown): CallError {
  const [code, message] = [fieldOf(error, "code"), fieldOf(error, "message")];
  const text = typeof code === "string" ? code : "error";
  return new CallError(text, typeof message === "string" && message !== "" ? message : text);
}

/** The address of the controls of the server that a page came from. */
export const controlUrl = ({ protocol, host }: Pick<Location, "protocol" | "host">): string => `${protocol === "https:" ? "wss" : "ws"}://${host}/api/v1/control/hold`;

export function createControlLink({ open, now, every, onChange }: LinkOptions) {
  let state: LinkState = { kind: "none" };
  let socket: ControlSocket | undefined;
  let endBeats: (() => void) | undefined;
  /** That this page was silent, if it was until now. */
  let silence: () => string | undefined = () => undefined;
  let calls = 0;
  /** That the server lets wait for responses. */
  let mostCalls = 0;
  const pending = new Map<number, Pending>();
  /** Of takings: an address that comes late is for none that was given up. */
  let attempt = 0;

  const change = (next: LinkState): void => {
    state = next;
    onChange(next);
  };
  const send = (request: ControlRequest): void => socket?.send(JSON.stringify(request));

  /** Nothing of the connection is left; `next` says why. */
  function end(next: LinkState): void {
    attempt++;
    endBeats?.();
    endBeats = undefined;
    const closed = socket;
    socket = undefined;
    closed?.close();
    const unanswered = [...pending.values()];
    pending.clear();
    change(next);
    for (const { reject } of unanswered) reject(new CallError("leased", "you have the controls no more"));
  }

  /** A connection that ends, or a message that nobody understands. */
  const fail = (why: string): void => end(state.kind === "held" ? { kind: "lost", why } : { kind: "refused", why });

  function beat(beat_ms: number, silence_ms: number): void {
    let last = now();
    silence = () => (now() - last > silence_ms ? `this page stood still for ${Math.round(now() - last)} ms` : undefined);
    send({ type: "beat" });
    endBeats = every(beat_ms * kEarly, () => {
      // The server has heard nothing for so long: what it says of it may still be on its way.
      const why = silence();
      last = now();
      if (why !== undefined) fail(why);
      else send({ type: "beat" });
    });
  }

  function receive(message: ControlMessage): void {
    switch (message.kind) {
      case "taken": {
        const { number, secret, beat_ms, silence_ms, most_calls } = message;
        mostCalls = most_calls;
        beat(beat_ms, silence_ms);
        change({ kind: "held", number, secret, since: now() });
        return;
      }
      case "asked":
        change({ kind: "asked", request: message.request, since: now() });
        return;
      case "refused":
        // Of a message while they are held, nothing changes.
        if (state.kind !== "held") end({ kind: "refused", why: message.message });
        return;
      case "lost":
        fail(silence() ?? message.message);
        return;
      case "released":
        end({ kind: "none" });
        return;
      case "response": {
        const call = pending.get(message.number);
        pending.delete(message.number);
        if (message.error === undefined) call?.resolve(message.result ?? null);
        else call?.reject(callError(message.error));
      }
    }
  }

  function connect(address: string, force: boolean): void {
    const mine = attempt;
    const ifMine = (act: () => void): void => (mine === attempt ? act() : undefined);
    socket = open(address, {
      onOpen: () => ifMine(() => send(force ? { type: "take", force } : { type: "take" })),
      onClose: () => ifMine(() => fail("the connection to the server has ended")),
      onText: (text) => ifMine(() => read(text)),
    });
  }
  function read(text: string): void {
    try {
      receive(check(schema.controlMessage, JSON.parse(text) as unknown));
    } catch (error) {
      if (!(error instanceof SchemaError)) throw error;
      fail(error.message);
    }
  }

  return {
    get: (): LinkState => state,
    /** For the header of requests that need the controls. */
    secret: (): string | undefined => (state.kind === "held" ? state.secret : undefined),
    /** A person wants them; `force`: also if somebody has them. `address`: of the connection, with a ticket if there are accounts. */
    take(address: () => Promise<string>, force = false): void {
      if (state.kind === "held" || state.kind === "taking" || state.kind === "asked") return;
      change({ kind: "taking" });
      const mine = ++attempt;
      address().then(
        (given) => mine === attempt && connect(given, force),
        (error: unknown) => mine === attempt && fail(error instanceof Error ? error.message : String(error)),
      );
    },
    /** Gives them back, or asks for them no more; `why`: not by a person, who is told. */
    release(why?: string): void {
      if (state.kind !== "held" && state.kind !== "taking" && state.kind !== "asked") return;
      if (state.kind === "held") send({ type: "release" });
      end(why === undefined ? { kind: "none" } : { kind: state.kind === "held" ? "lost" : "refused", why });
    },
    /** A person has read why they have them no more. */
    dismiss(): void {
      if (state.kind === "lost" || state.kind === "refused") change({ kind: "none" });
    },
    /** Calls an operation by hand. Rejects with a CallError. */
    call(service: string, operation: string, kwargs: Readonly<Record<string, JsonValue>> = {}): Promise<JsonValue> {
      if (state.kind !== "held") return Promise.reject(new CallError("leased", "take the controls first"));
      if (pending.size >= mostCalls * (operation === "stop" ? 1 : kUsual)) return Promise.reject(new CallError("too_large", "the server does not answer"));
      const number = ++calls;
      return new Promise<JsonValue>((resolve, reject) => {
        pending.set(number, { resolve, reject });
        send({ type: "call", number, service, operation, kwargs });
      });
    },
  };
}

export type ControlLink = ReturnType<typeof createControlLink>;
