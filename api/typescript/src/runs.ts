// Stored runs: they stay when their cores are gone.
import { deleteRun, exportRun, getRun, getRunDerivations, getRunJournal, listRuns } from "./calls/runs.js";
import type { StepRange } from "./cores.js";
import type { Journal, Run, RunFile, RunRemoved, Runs as RunPage, TraceStep } from "./generated/messages.js";
import { derivationPages, type Sender, type SendOptions } from "./sender.js";

/** The runs that the server has stored. `id` is the number of a run, as text, and of the core that hosts it. */
export class Runs {
  constructor(private readonly client: Sender) {}

  /** Each run, of one document or of all, the newest first. They come page by page. */
  async *all({ document, ...options }: SendOptions & { readonly document?: string | undefined } = {}): AsyncGenerator<Run, void> {
    let before: number | undefined;
    do {
      const page: RunPage = await this.client.send(listRuns({ document, before }), options);
      yield* page.runs;
      before = page.next;
    } while (before !== undefined);
  }

  /** One run: `status`, `outcome`, `results`, `arguments`, `steps`, when it was `created` and `ended` [ms since 1970, UTC]. */
  async get(id: string, options?: SendOptions): Promise<Run> {
    return await this.client.send(getRun(id), options);
  }

  /** As of a core. RaceError 422 `version`: another version of the server executed it; 413 `too_large`: its replay takes too long. */
  async *derivations(id: string, { first = 1, last, ...options }: StepRange = {}): AsyncGenerator<TraceStep, void> {
    const end = last ?? (await this.get(id, options)).steps;
    yield* derivationPages((from, to) => this.client.send(getRunDerivations(id, { from, to }), options), first, end);
  }

  /** Header and inputs of the run, of which it is a function. RaceError 413 `too_large`: more than 16 MiB. */
  async journal(id: string, options?: SendOptions): Promise<Journal> {
    return await this.client.send(getRunJournal(id), options);
  }

  /** All of a run in one file, which any server of this version opens. RaceError 413 `too_large`: more than 16 MiB. */
  async export(id: string, options?: SendOptions): Promise<RunFile> {
    return await this.client.send(exportRun(id), options);
  }

  /** Removes it from the store. RaceError 409 `conflict`: a core has it. */
  async delete(id: string, options?: SendOptions): Promise<RunRemoved> {
    return await this.client.send(deleteRun(id), options);
  }
}
