// The client: who asks which server, and what it offers.
import { checkedToken, originOf } from "./address.js";
import { kStreamPath } from "./calls/index.js";
import { createTicket, getHealth, logIn, logOut } from "./calls/server.js";
import { getMe } from "./calls/me.js";
import { resetStop, stopCell } from "./calls/stop.js";
import type { Call } from "./call.js";
import { Cores } from "./cores.js";
import { Documents } from "./documents.js";
import { kConnection, RaceError } from "./errors.js";
import type { Control, Empty, Health, LoginAnswer, Me } from "./generated/messages.js";
import { pause, within } from "./limits.js";
import { request, withToken, type Transport } from "./request.js";
import { Runs } from "./runs.js";
import type { Sender, SendOptions } from "./sender.js";
import { Services } from "./services.js";
import { openFollowing, passes, type Following, type FollowOptions } from "./stream/following.js";
import type { SocketConstructor } from "./stream/socket.js";

export interface ClientOptions {
  /** Of an account (`race account token`), or by `logIn`; a server without accounts needs none. */
  readonly token?: string | undefined;
  /** [s] for each answer: 20. */
  readonly timeout?: number | undefined;
  /** Nothing: that of the browser or of Node. */
  readonly fetch?: typeof fetch | undefined;
  /** For `cores.follow`. Nothing: that of the browser, or of Node 22. */
  readonly webSocket?: SocketConstructor | undefined;
}

/** How often a stop is sent, and [s] for each and in between. */
const kStop = { tries: 3, timeout: 3, pause: 0.1 };

/**
 * A client of one server. `documents`, `cores`, `runs` and `services` have what is asked most; `send` sends any other route of `calls`.
 * Nothing is connected before the first request. What refuses a request, or keeps its answer away, is a RaceError.
 */
export class Client implements Sender {
  readonly documents = new Documents(this);
  readonly cores = new Cores(this);
  readonly runs = new Runs(this);
  readonly services = new Services(this);
  private readonly transport: Transport;
  private readonly timeout: number;
  private token: string | undefined;

  /** `address`: `http://127.0.0.1:8080`, or `https://HOST:PORT` of another machine. Throws a TypeError: it, or the token, can be none. */
  constructor(
    address = "http://127.0.0.1:8080",
    private readonly options: ClientOptions = {},
  ) {
    const origin = originOf(address);
    this.token = options.token === undefined ? undefined : checkedToken(options.token);
    this.timeout = options.timeout ?? 20;
    const fetcher: typeof fetch = options.fetch ?? ((input, init) => fetch(input, init));
    this.transport = { origin, fetch: withToken(fetcher, () => this.token) };
  }

  /** The answer to a request of `calls`, within `timeout` seconds (else those of the client). What only reads is asked again once if the connection ends. */
  async send<Answer>(call: Call<Answer>, { timeout = this.timeout, signal }: SendOptions = {}): Promise<Answer> {
    return await within(timeout, signal, async (both) => {
      try {
        return await request(this.transport, call, both);
      } catch (error) {
        const isLost = error instanceof RaceError && error.code === kConnection && error.mayBeDone;
        if (call.method !== "GET" || !isLost) throw error;
      }
      return await request(this.transport, call, both);
    });
  }

  /** As `cores.follow`. */
  async follow(core: string, options: FollowOptions = {}): Promise<Following> {
    const { timeout } = this;
    const { origin } = this.transport;
    const streamAddress = async (): Promise<string> => {
      // It also says why there is no stream, which no WebSocket tells.
      const { ticket } = await this.send(createTicket());
      return `${origin.replace(/^http/, "ws")}${kStreamPath}?ticket=${encodeURIComponent(ticket)}`;
    };
    const server = { where: origin, timeout, streamAddress, ask: () => this.health(), webSocket: this.options.webSocket };
    return await openFollowing(server, core, options);
  }

  /** Asks as this account from now on, for twelve hours at most. RaceError 401 `login`: no such name and password; 429 `attempts`. */
  async logIn(name: string, password: string): Promise<LoginAnswer> {
    const answer = await this.send(logIn({ name, password }));
    this.token = checkedToken(answer.token);
    return answer;
  }

  /** Ends the token; the server knows this client no more. */
  async logOut(): Promise<Empty> {
    const answer = await this.send(logOut());
    this.token = undefined;
    return answer;
  }

  /** Who asks: `name` and `role` of the account, if the server has `accounts`. */
  async me(options?: SendOptions): Promise<Me> {
    return await this.send(getMe(), options);
  }

  /** The server answers: `version`, `time` [s] of its clock, whether it has a `cell`. */
  async health(options?: SendOptions): Promise<Health> {
    return await this.send(getHealth(), options);
  }

  /**
   * Stops everything that moves, and all runs, until `resetStop`. Needs no account. This is not a safety function. As it may be done
   * twice, it is sent again if no answer comes: three times, for 3 s each.
   */
  async stopCell(): Promise<Control> {
    let mayBeDone = false;
    for (let tries = kStop.tries; ; ) {
      try {
        return await this.send(stopCell(), { timeout: Math.min(kStop.timeout, this.timeout) });
      } catch (error) {
        if (!(error instanceof RaceError)) throw error;
        mayBeDone ||= error.mayBeDone;
        error.mayBeDone = mayBeDone;
        if (--tries === 0 || !(passes(error) || error.status === 503)) throw error;
      }
      await pause(kStop.pause);
    }
  }

  /** Motions may begin again; none does by this. */
  async resetStop(): Promise<Control> {
    return await this.send(resetStop());
  }
}
