// Conversations of api/conversations, held with a Client. What comes is held against api/ by the library.
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { calls, plain, RaceError, ServiceError, type Call, type Client, type ExactJson, type Following, type JsonValue, type Update } from "../../api/typescript/src/index";
import { all } from "./asserting";
import { at, folder, mismatch, Values, valueOf, type Fields } from "./conversationValues";
import type { Account } from "./servers";

/** As format/conversations.schema.json has it. */
export interface Step {
  readonly let?: Fields;
  readonly call?: string;
  readonly path?: Fields;
  readonly query?: Fields;
  readonly headers?: Fields;
  readonly body?: ExactJson;
  readonly ask?: string;
  readonly arguments?: readonly ExactJson[];
  readonly options?: Fields;
  readonly follow?: string;
  readonly next?: "updates";
  readonly within?: number;
  readonly rest?: "updates";
  readonly by?: Account;
  readonly answer?: ExactJson;
  readonly refused?: ExactJson;
  readonly until?: ExactJson;
  readonly save?: Readonly<Record<string, string>>;
}

export interface ConversationFile {
  readonly conversations: readonly { readonly title: string; readonly server?: "plain" | "accounts" | "demo"; readonly steps: readonly Step[] }[];
}

export const allConversations = (): ConversationFile["conversations"] =>
  readdirSync(folder).filter((name) => name.endsWith(".json")).flatMap((name) => (JSON.parse(readFileSync(join(folder, name), "utf8")) as ConversationFile).conversations);

/** [s]; no conversation needs them. */
const kPatience = 20;

/** `If-Match` -> ifMatch, `log_in` -> logIn. */
const camel = (name: string): string => name.replace(/[-_](\w)/g, (_, letter: string) => letter.toUpperCase()).replace(/^\w/, (letter) => letter.toLowerCase());
const camelFields = (fields: Fields): Fields => Object.fromEntries(Object.entries(fields).map(([name, value]) => [camel(name), value]));

/** As a pattern has it: values of JSON, without what is undefined. */
const asJson = (value: unknown): ExactJson => (value === undefined ? null : plain<JsonValue>(value as ExactJson));

/** What a pattern may say of an error. */
function errorFields(error: RaceError): ExactJson {
  const { status, code, path, errors, mayBeDone } = error;
  const ofService = error instanceof ServiceError ? { service: error.service, operation: error.operation, error: error.error } : {};
  return asJson({ status, code, path, errors, may_be_done: mayBeDone, ...ofService });
}

const isIterable = (value: unknown): value is AsyncIterable<unknown> => typeof value === "object" && value !== null && Symbol.asyncIterator in value;
type Method = (...given: readonly unknown[]) => unknown;

/** A method of the client, or of a part of it, by its name. */
function methodOf(race: Client, name: string): Method {
  const [first = "", second] = name.split(".");
  const owner: object = second === undefined ? race : (Reflect.get(race, first) as object);
  return (Reflect.get(owner, camel(second ?? first)) as Method).bind(owner);
}

/** One conversation. `clientOf`: makes a client with a token of an account, or without one. */
export class Conversation {
  private readonly clients = new Map<Account | undefined, Client>();
  private readonly saved = new Values();
  private updates: Following | undefined;

  constructor(private readonly clientOf: (account: Account | undefined) => Client) {}

  /** All steps, one after the other. Rejects if something else comes than a step says. */
  async hold(steps: readonly Step[]): Promise<void> {
    try {
      for (const [i, step] of steps.entries()) {
        const why = await this.holdStep(step);
        if (why !== undefined) throw new Error(`step ${i + 1}, ${JSON.stringify(step).slice(0, 300)}: ${why}`);
      }
    } finally {
      this.updates?.close();
    }
  }

  /** Why a step does not come to what it says. */
  private async holdStep(step: Step): Promise<string | undefined> {
    for (const end = Date.now() + 1000 * kPatience; ; await new Promise((resolve) => setTimeout(resolve, 20))) {
      const { answer, error } = await this.outcome(step);
      if (error !== undefined) return step.refused === undefined ? `it is refused: ${JSON.stringify(error)}` : mismatch(step.refused, error, this.saved);
      if (step.refused !== undefined) return `it is answered: ${JSON.stringify(answer).slice(0, 300)}`;
      const wanted = "answer" in step ? step.answer : step.until;
      const why = wanted === undefined ? undefined : mismatch(wanted, answer, this.saved);
      if (why === undefined) for (const [name, pointer] of Object.entries(step.save ?? {})) this.saved.set(name, at(answer, pointer));
      if (why === undefined || step.until === undefined || Date.now() > end) return why;
    }
  }

  private async outcome(step: Step): Promise<{ readonly answer: ExactJson; readonly error?: ExactJson }> {
    try {
      return { answer: asJson(await this.do(step)) };
    } catch (error) {
      if (!(error instanceof RaceError)) throw error;
      return { answer: null, error: errorFields(error) };
    }
  }

  /** What a step is answered. */
  private async do(step: Step): Promise<unknown> {
    const { saved } = this;
    if (step.let !== undefined) {
      for (const [name, given] of Object.entries(step.let)) saved.set(name, valueOf(given, saved));
      return undefined;
    }
    if (step.next !== undefined) return await this.next(step.within);
    if (step.rest !== undefined) return await all(this.following());
    const race = this.client(step.by);
    const options: object = camelFields(valueOf(step.options ?? {}, saved) as Fields);
    if (step.follow !== undefined) {
      this.updates = await race.cores.follow(valueOf(step.follow, saved) as string, { quiet: kPatience, ...options });
      return undefined;
    }
    if (step.call !== undefined) return await race.send(this.callOf(step.call, step));
    const words = valueOf(step.arguments ?? [], saved) as readonly ExactJson[];
    const answer = methodOf(race, step.ask ?? "")(...words, ...(step.options === undefined ? [] : [options]));
    return isIterable(answer) ? await all(answer) : await answer;
  }

  private following(): Following {
    if (this.updates === undefined) throw new Error("no core is followed");
    return this.updates;
  }

  private async next(within: number | undefined): Promise<Update | undefined> {
    return within === undefined ? (await this.following().next()).value : await this.following().take(within);
  }

  private client(account: Account | undefined): Client {
    const client = this.clients.get(account) ?? this.clientOf(account);
    this.clients.set(account, client);
    return client;
  }

  private callOf(name: string, step: Step): Call<unknown> {
    const { saved } = this;
    const [path, query, headers] = [step.path, step.query, step.headers].map((given) => valueOf(given ?? {}, saved) as Fields);
    const body = step.body === undefined ? [] : [step.body === null ? undefined : valueOf(step.body, saved)];
    return (Reflect.get(calls, name) as (...given: readonly unknown[]) => Call<unknown>)(...Object.values(path ?? {}), ...body, camelFields({ ...query, ...headers }));
  }
}
