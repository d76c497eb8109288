// Requests to the server. Each answer is checked against its schema.
import type {
  Account,
  AccountChange,
  AccountCreate,
  Breakpoint,
  Breakpoints,
  CellReset,
  Core,
  CoreConfirmEdit,
  CoreCreate,
  CoreResume,
  CoreStart,
  DocumentBranch,
  DocumentBreakpoints,
  DocumentEntry,
  DocumentRemoved,
  DocumentRestore,
  Documents,
  DocumentSummary,
  Force,
  Health,
  Journal,
  KeptBreakpoint,
  Native,
  PairingCreate,
  PairingCreated,
  Past,
  Person,
  PersonCommand,
  Proposal,
  ProposalDecline,
  Revisions,
  Rule,
  Run,
  RunComparison,
  Runs,
  RunPicture,
  RunPictures,
  Samples,
  Scene,
  ServerError,
  ServiceCall,
  StepRequest,
  Timing,
  TraceStep,
  Why,
} from "../generated/messages";
import * as schema from "../generated/validators";
import { isObject, type JsonValue } from "./json";
import type { MicroStep } from "./derivation/proof";
import { readExact, writeExact, type Exact } from "./edit/exact";
import { check, type Validator } from "./messages/check";
import type { Wanted } from "./past/moment";
import { placesIn, type Places } from "./drawing/places";
import { withAfters } from "./model/afters";
import type { RcmDocument } from "./model/model";
import { withOracles } from "./model/oracles";
import { readModel } from "./model/readModel";
import { subjectQuery, type Subject } from "./run/subject";

/** The server refused a request: its errors, as it gave them. */
export class RefusedError extends Error {
  constructor(
    readonly status: number,
    readonly errors: readonly ServerError[],
    /** There are more than the listed ones. */
    readonly more?: true,
  ) {
    super(errors.map((error) => (error.path === "" ? error.message : `${error.path}: ${error.message}`)).join("; "));
    this.name = "RefusedError";
  }
}

/** A service has answered an error: what it says of it. */
export class ServiceError extends Error {
  readonly code: string;
  constructor(error: JsonValue) {
    const [code, message] = isObject(error) ? [error["code"], error["message"]] : [undefined, undefined];
    super(typeof message === "string" && message !== "" ? message : typeof code === "string" ? code : "the service answers an error");
    this.name = "ServiceError";
    this.code = typeof code === "string" ? code : "error";
  }
}

const segment = encodeURIComponent;

/** The arguments of a run, with the numbers as they were written. */
export type ExactArguments = Exact<Core["arguments"]>;

/** The entity tag of a revision. */
const tagOf = (revision: number): string => `"${revision}"`;

/** What answers a question about a run: the core that hosts it, or the store. */
export type RunSource = "cores" | "runs";

export function readNative({ document, origin }: Native): RcmDocument {
  const model = readModel(document);
  return { ...model, root: withOracles(withAfters(model.root, origin), origin) };
}

/** The error of an answer that says why a request was refused. */
function refusedError(status: number, data: unknown): RefusedError {
  const { errors, more_errors } = check(schema.problem, data);
  return new RefusedError(status, errors, more_errors);
}

/** How a document is stored. */
export interface Storing {
  /** The revision that it follows; nothing: there must be no document of its name. */
  readonly onto?: number;
  /** It may have errors. */
  readonly draft?: boolean;
  readonly author: string;
}

/** Requests below `base` (`/api/v1`); `fetcher` is the browser's fetch, or a test's. */
export function createApi(base: string, fetcher: typeof fetch) {
  type Body = AccountChange | AccountCreate | Breakpoints | CellReset | CoreConfirmEdit | CoreResume | CoreStart | DocumentBreakpoints | Exact<Force> | Exact<CoreCreate> | DocumentBranch | PairingCreate | PersonCommand | ProposalDecline | ServiceCall | StepRequest | { readonly live: boolean };
  async function request<T>(method: string, path: string, validator: Validator<T>, body?: Body): Promise<T> {
    return send(path, body === undefined ? { method } : { method, body: writeExact(body), headers: { "content-type": "application/json" } }, validator);
  }
  async function send<T>(path: string, init: RequestInit, validator: Validator<T>): Promise<T> {
    const answer = await fetcher(`${base}${path}`, init);
    const data: unknown = await answer.json();
    if (!answer.ok) throw refusedError(answer.status, data);
    return check(validator, data);
  }
  /** Of an answer that is accepted. */
  async function requestText<T>(path: string, validator: Validator<T>): Promise<string> {
    const answer = await fetcher(`${base}${path}`, { method: "GET" });
    const text = await answer.text();
    const data: unknown = JSON.parse(text);
    if (!answer.ok) throw refusedError(answer.status, data);
    check(validator, data);
    return text;
  }
  const get = <T>(path: string, validator: Validator<T>) => request("GET", path, validator);
  const documentAt = (name: string, revision: number): Promise<DocumentEntry> => get(`/documents/${segment(name)}/revisions/${revision}`, schema.documentEntry);
  const breakpointsOf = (name: string, author: string): string => `/documents/${segment(name)}/breakpoints?author=${segment(author)}`;
  const command = (id: string, name: string) => request("POST", `/cores/${segment(id)}/${name}`, schema.core);
  return {
    health: (): Promise<Health> => get("/health", schema.health),
    accounts: async (): Promise<readonly Account[]> => (await get("/accounts", schema.accounts)).accounts,
    addAccount: (account: AccountCreate): Promise<Account> => request("POST", "/accounts", schema.account, account),
    changeAccount: (name: string, change: AccountChange): Promise<Account> => request("PUT", `/accounts/${segment(name)}`, schema.account, change),
    removeAccount: async (name: string): Promise<void> => void (await request("DELETE", `/accounts/${segment(name)}`, schema.accountRemoved)),
    rules: async (): Promise<readonly Rule[]> => (await get("/rules", schema.rules)).rules,
    documents: async (): Promise<readonly DocumentSummary[]> => {
      const all: DocumentSummary[] = [];
      for (let after: string | undefined = ""; after !== undefined; ) {
        const page: Documents = await get(`/documents?after=${segment(after)}`, schema.documents);
        all.push(...page.documents);
        after = page.next;
      }
      return all;
    },
    document: (name: string): Promise<DocumentEntry> => get(`/documents/${segment(name)}`, schema.documentEntry),
    /** As it was in a revision. */
    documentAt,
    /** The same as a model, and where its states were placed. Throws for a draft. */
    modelAt: async (name: string, revision: number): Promise<{ readonly document: RcmDocument; readonly places: Places }> => {
      const { document } = await documentAt(name, revision);
      return { document: readModel(check(schema.native, { document, origin: {} }).document), places: placesIn(document["layout"]) };
    },
    /** The last revision as a run would execute it. Throws for a draft. */
    documentModel: async (name: string): Promise<RcmDocument> => readNative(await get(`/documents/${segment(name)}/native`, schema.native)),
    /** The last revision as it was sent, with the numbers as they were written (edit/exact.ts). */
    documentText: (name: string): Promise<string> => requestText(`/documents/${segment(name)}`, schema.documentEntry),
    /** Stores the content as it is. */
    putDocument: (name: string, content: Blob | string, { onto, draft = false, author }: Storing): Promise<DocumentEntry> => {
      const headers = { "content-type": "application/json", ...(onto === undefined ? { "if-none-match": "*" } : { "if-match": tagOf(onto) }) };
      return send(`/documents/${segment(name)}?draft=${draft}&author=${segment(author)}`, { method: "PUT", body: content, headers }, schema.documentEntry);
    },
    /** `revision`: of the document that is branched; nothing: the last one. */
    branchDocument: (name: string, as: string, author: string, revision?: number): Promise<DocumentEntry> =>
      request("POST", `/documents/${segment(name)}/branch`, schema.documentEntry, { as, author, ...(revision !== undefined && { revision }) }),
    /** The newest first, at most 100; only those before `before`. */
    revisions: (name: string, before?: number): Promise<Revisions> =>
      get(`/documents/${segment(name)}/revisions${before === undefined ? "" : `?before=${before}`}`, schema.revisions),
    /** Makes an earlier revision the next one, if `onto` is the last one. */
    restoreDocument: (name: string, revision: number, { onto, author }: { readonly onto: number; readonly author: string }): Promise<DocumentEntry> => {
      const body: DocumentRestore = { revision, author };
      return send(`/documents/${segment(name)}/restore`, { method: "POST", body: writeExact(body), headers: { "content-type": "application/json", "if-match": tagOf(onto) } }, schema.documentEntry);
    },
    /** With all its revisions, the last of which must be `revision`. */
    deleteDocument: (name: string, revision: number): Promise<DocumentRemoved> =>
      send(`/documents/${segment(name)}`, { method: "DELETE", headers: { "if-match": tagOf(revision) } }, schema.documentRemoved),
    /** With the document that it proposes. */
    proposal: (id: string): Promise<Proposal> => get(`/proposals/${segment(id)}`, schema.proposal),
    /** It becomes the next revision of its document. */
    acceptProposal: (id: string, author: string): Promise<Proposal> => request("POST", `/proposals/${segment(id)}/accept?author=${segment(author)}`, schema.proposal),
    declineProposal: (id: string, author: string, reason: string): Promise<Proposal> =>
      request("POST", `/proposals/${segment(id)}/decline?author=${segment(author)}`, schema.proposal, reason === "" ? {} : { reason }),
    withdrawProposal: (id: string, author: string): Promise<Proposal> => request("DELETE", `/proposals/${segment(id)}?author=${segment(author)}`, schema.proposal),
    /** The breakpoints that a person keeps at a document. */
    breakpoints: async (name: string, author: string): Promise<readonly KeptBreakpoint[]> => (await get(breakpointsOf(name, author), schema.documentBreakpoints)).breakpoints,
    keepBreakpoints: (name: string, author: string, breakpoints: readonly KeptBreakpoint[]): Promise<unknown> =>
      request("PUT", breakpointsOf(name, author), schema.documentBreakpoints, { breakpoints }),
    /** Replaces those that a person has set in a core. */
    setBreakpoints: (id: string, author: string, breakpoints: readonly Breakpoint[]): Promise<Core> =>
      request("PUT", `/cores/${segment(id)}/breakpoints?author=${segment(author)}`, schema.core, { breakpoints }),
    force: (id: string, force: Exact<Force>): Promise<Core> => request("POST", `/cores/${segment(id)}/force`, schema.core, force),
    /** The arguments that a run was made with, with the numbers as they were written. */
    runArguments: async (id: string, of: RunSource): Promise<ExactArguments> =>
      (readExact(await requestText<Core | Run>(`/${of}/${segment(id)}`, of === "cores" ? schema.core : schema.run)) as unknown as { readonly arguments: ExactArguments }).arguments,
    createCore: (document: string, args: ExactArguments): Promise<Core> => request("POST", "/cores", schema.core, { document, arguments: args }),
    coreModel: async (id: string): Promise<RcmDocument> => readNative(await get(`/cores/${segment(id)}/native`, schema.native)),
    /** `supervised`: nothing of it moves while who begins it is away from the controls of the cell. */
    start: (id: string, supervised = false): Promise<Core> => (supervised ? request("POST", `/cores/${segment(id)}/start`, schema.core, { supervised }) : command(id, "start")),
    pause: (id: string): Promise<Core> => command(id, "pause"),
    /** The same; otherwise it stays as it was. */
    resume: (id: string, supervised = false): Promise<Core> => (supervised ? request("POST", `/cores/${segment(id)}/resume`, schema.core, { supervised }) : command(id, "resume")),
    /** Lets an edit that waits for it reach the run. */
    confirmEdit: (id: string, revision: number): Promise<Core> => request("POST", `/cores/${segment(id)}/confirm_edit`, schema.core, { revision }),
    stop: (id: string): Promise<Core> => command(id, "stop"),
    step: (id: string, step: StepRequest): Promise<Core> => request("POST", `/cores/${segment(id)}/step`, schema.core, step),
    setLive: (id: string, live: boolean): Promise<Core> => request("PUT", `/cores/${segment(id)}/live`, schema.core, { live }),
    derivations: async (id: string, from: number, to: number, of: RunSource = "cores"): Promise<readonly TraceStep[]> =>
      (await get(`/${of}/${segment(id)}/derivations?from=${from}&to=${to}`, schema.derivations)).steps,
    /** The run as it was at a moment. */
    past: (of: RunSource, id: string, { step, micro }: Wanted): Promise<Past> =>
      get(`/${of}/${segment(id)}/past?step=${step}${micro === undefined ? "" : `&micro=${micro}`}`, schema.past),
    /** At most 100 of the stored runs, the newest first; `before`: only those with a smaller number. */
    runs: (document?: string, before?: number): Promise<Runs> => {
      const query = new URLSearchParams({ ...(document !== undefined && { document }), ...(before !== undefined && { before: String(before) }) });
      return get(`/runs?${query.toString()}`, schema.runs);
    },
    storedRun: (id: string): Promise<Run> => get(`/runs/${segment(id)}`, schema.run),
    /** Stores the file of a run as a new one. */
    importRun: (file: string): Promise<Run> => send("/runs", { method: "POST", body: file, headers: { "content-type": "application/json" } }, schema.run),
    /** Where two runs first differ, from a macro step on. */
    compareRuns: (id: string, other: string, from = 1): Promise<RunComparison> => get(`/runs/${segment(id)}/compare?with=${segment(other)}&from=${from}`, schema.runComparison),
    /** Where the file of a run can be loaded. */
    runFileAddress: (id: string): string => `${base}/runs/${segment(id)}/export`,
    deleteCore: (id: string): Promise<Core> => request("DELETE", `/cores/${segment(id)}`, schema.core),
    deleteRun: async (id: string): Promise<void> => void (await request("DELETE", `/runs/${segment(id)}`, schema.runRemoved)),
    /** The model that it began with. */
    runModel: async (id: string): Promise<RcmDocument> => readNative(await get(`/runs/${segment(id)}/native`, schema.native)),
    /** Where everything in the cell was while it ran. */
    samples: async (id: string): Promise<Samples> => (await get(`/runs/${segment(id)}/samples`, schema.runSamples)).samples,
    /** Which pictures of cameras are kept of it, in order. */
    pictures: async (id: string): Promise<RunPictures["pictures"]> => (await get(`/runs/${segment(id)}/pictures`, schema.runPictures)).pictures,
    picture: (id: string, number: number): Promise<RunPicture> => get(`/runs/${segment(id)}/pictures/${number}`, schema.runPicture),
    /** When macro steps began, and which states services had. */
    timing: (id: string, from: number, to: number): Promise<Timing> => get(`/runs/${segment(id)}/timing?from=${from}&to=${to}`, schema.timing),
    journal: (id: string): Promise<Journal> => get(`/runs/${segment(id)}/journal`, schema.journal),
    /** As things are now, or as they were in a past micro step. */
    why: (of: RunSource, id: string, subject: Subject, before?: MicroStep): Promise<Why> =>
      get(`/${of}/${segment(id)}/why?${subjectQuery(subject)}${before === undefined ? "" : `&step=${before.step}&micro=${before.micro}`}`, schema.why),
    /** A code with which a phone is let in. */
    createPairing: (pairing: PairingCreate): Promise<PairingCreated> => request("POST", "/pairings", schema.pairingCreated, pairing),
    /** Calls an operation of a service that moves nothing. Rejects with a ServiceError if it answers an error. */
    callService: async (service: string, operation: string, kwargs: Readonly<Record<string, JsonValue>>): Promise<JsonValue> => {
      const response = await request("POST", `/services/${segment(service)}/calls`, schema.serviceResponse, { operation, kwargs });
      if (response.error !== undefined) throw new ServiceError(response.error);
      return response.result ?? null;
    },
    cell: (): Promise<Scene> => get("/cell", schema.scene),
    person: (): Promise<Person> => get("/cell/person", schema.person),
    command: (body: PersonCommand): Promise<Person> => request("POST", "/cell/person", schema.person, body),
    /** The cell as it was at the start; with `database`, that, too. */
    resetCell: (database: boolean): Promise<Person> => request("POST", "/cell/reset", schema.person, { database }),
    /** Address of a file that the scene names. */
    cellFile: (file: string): string => `${base}/cell/${segment(file)}`,
  };
}

export type Api = ReturnType<typeof createApi>;
