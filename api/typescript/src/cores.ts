// Cores: each hosts one run of a document.
import { createCore, deleteCore, getCore, getCoreState, getDerivations, listCores, pauseCore, resumeCore, startCore, stopCore } from "./calls/cores.js";
import { failure, isTimeout, kTimeout } from "./errors.js";
import type { Exact } from "./exact.js";
import type { Core, CoreState, TraceStep } from "./generated/messages.js";
import { within } from "./limits.js";
import { newId } from "./newId.js";
import { derivationPages, sendTwice, type Sender, type SendOptions } from "./sender.js";
import { isOver } from "./stream/fold.js";
import type { Following, FollowOptions } from "./stream/following.js";

/** Of the root's parameters, over their values. */
export type Arguments = Exact<Core["arguments"]>;

export interface CreateOptions extends SendOptions {
  /** It follows the edits of the document. */
  readonly live?: boolean | undefined;
  /** Of this request, else a new one. */
  readonly key?: string | undefined;
}

export interface ControlOptions extends SendOptions {
  /** The secret of who has the controls of the cell. */
  readonly control?: string | undefined;
}

/** Macro steps; nothing: from the first, to the last so far. */
export interface StepRange extends SendOptions {
  readonly first?: number | undefined;
  readonly last?: number | undefined;
}

/** The cores of the server. `id` is the number of a core, as text, and of its run. */
export class Cores {
  constructor(private readonly client: Sender) {}

  /** All cores, running or not. */
  async all(options?: SendOptions): Promise<readonly Core[]> {
    return (await this.client.send(listCores(), options)).cores;
  }

  /** One core: `status`, `step` (macro steps begun), `outcome`, `results`, `fault`. RaceError 404 `not_found`. */
  async get(id: string, options?: SendOptions): Promise<Core> {
    return await this.client.send(getCore(id), options);
  }

  /**
   * A core of the document's last revision, which waits to be started. If its answer does not come it is asked for again with the same
   * key, and one core is made. RaceError 422: an argument does not fit, or the document has violations; 409 `conflict`: there are 128 cores.
   */
  async create(document: string, args: Arguments = {}, { live = false, key = newId(), ...options }: CreateOptions = {}): Promise<Core> {
    return await sendTwice(this.client, createCore({ document, live, arguments: args }, { idempotencyKey: key }), options);
  }

  /**
   * Starts a core that waits; `args` take the place of those that it was created with. RaceError 409 `conflict`: it was started before;
   * `stopped`: the cell is; `leased`: somebody else has the controls. 422: an argument does not fit.
   */
  async start(id: string, args?: Arguments, { control, ...options }: ControlOptions = {}): Promise<Core> {
    return await this.client.send(startCore(id, args === undefined ? {} : { arguments: args }, { raceControl: control }), options);
  }

  /** Holds it between macro steps; inputs wait. RaceError 409: it is over. */
  async pause(id: string, options?: SendOptions): Promise<Core> {
    return await this.client.send(pauseCore(id), options);
  }

  /** Lets a paused or interrupted core go on. RaceError 409: it is over, or as of `start`. */
  async resume(id: string, { control, ...options }: ControlOptions = {}): Promise<Core> {
    return await this.client.send(resumeCore(id, undefined, { raceControl: control }), options);
  }

  /** Ends its run between macro steps: `status` becomes `aborted`, and what its services move stops. RaceError 409: it does not run. */
  async abort(id: string, options?: SendOptions): Promise<Core> {
    return await this.client.send(stopCore(id), options);
  }

  /** Removes the core, which is stopped before; its run stays in `runs`. */
  async delete(id: string, options?: SendOptions): Promise<Core> {
    return await this.client.send(deleteCore(id), options);
  }

  /** What is active, and all values, after the last step. */
  async state(id: string, options?: SendOptions): Promise<CoreState> {
    return await this.client.send(getCoreState(id), options);
  }

  /**
   * Its updates until the run is over, over the stream. Resolves when the first is there, so that what is done then is heard. Rejects
   * with a RaceError: there is no server, or no such core, or it takes more than `within` seconds.
   */
  async follow(id: string, options?: FollowOptions): Promise<Following> {
    return await this.client.follow(id, options);
  }

  /**
   * The core once its run is over: `status` ended (with `outcome` and `results`), faulted (with `fault`) or aborted. RaceError `timeout`:
   * after `timeout` seconds, or when `signal` says so, it is not, and the message says what it is instead; it goes on.
   */
  async wait(id: string, { timeout, signal }: SendOptions): Promise<Core> {
    const known = { status: "unknown" };
    try {
      return await within(timeout, signal, (both) => this.untilOver(id, timeout, both, (core) => (known.status = core.status)));
    } catch (error) {
      if (!isTimeout(error)) throw error;
      throw failure(kTimeout, `core ${id} is not over ${timeout === undefined ? "in time" : `after ${timeout} s`}: its status is ${known.status}`);
    }
  }

  /** Creates a core, starts it and waits for its end: errors of all three. It stays, for its derivations, until `delete`. */
  async run(document: string, args: Arguments, options: SendOptions): Promise<Core> {
    const { id } = await this.create(document, args, { signal: options.signal });
    await this.start(id, undefined, { signal: options.signal });
    return await this.wait(id, options);
  }

  /**
   * The derivations of macro steps, in order; they come page by page, computed anew each time. A step has its `input`, its micro steps
   * as proof trees (`micro`) and the `calls` that it has sent.
   */
  async *derivations(id: string, { first = 1, last, ...options }: StepRange = {}): AsyncGenerator<TraceStep, void> {
    const end = last ?? (await this.get(id, options)).step;
    yield* derivationPages((from, to) => this.client.send(getDerivations(id, { from, to }), options), first, end);
  }

  private async untilOver(id: string, timeout: number | undefined, signal: AbortSignal, onCore: (core: Core) => void): Promise<Core> {
    const core = await this.client.send(getCore(id), { timeout, signal });
    onCore(core);
    if (isOver(core.status)) return core;
    const updates = await this.client.follow(id, { patience: timeout, within: timeout, signal });
    let last = core;
    for await (const { state } of updates) {
      last = state.core;
      onCore(last);
    }
    return last;
  }
}
