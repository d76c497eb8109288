// What the pages ask the server for, by the calls of the client library.
import * as calls from "../../api/typescript/src/calls/index";
import { RawJson, targetOf, type Call } from "../../api/typescript/src/call";
import type { Arguments } from "../../api/typescript/src/cores";
import { request, requestText } from "../../api/typescript/src/request";
import { tagOf } from "../../api/typescript/src/sender";
import { resultOf } from "../../api/typescript/src/services";
import type {
  Account,
  AccountChange,
  AccountCreate,
  Breakpoint,
  BundleInstalled,
  Core,
  DocumentEntry,
  DocumentRemoved,
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
  Revisions,
  Rule,
  Run,
  RunComparison,
  RunPicture,
  RunPictures,
  Runs,
  Samples,
  Scene,
  StepRequest,
  Timing,
  TraceStep,
  Why,
} from "../generated/messages";
import * as schema from "../generated/validators";
import type { JsonValue } from "./json";
import type { MicroStep } from "./derivation/proof";
import { readExact, type Exact } from "./edit/exact";
import { check } from "./messages/check";
import type { Wanted } from "./past/moment";
import { placesIn, type Places } from "./drawing/places";
import { withAfters } from "./model/afters";
import type { RcmDocument } from "./model/model";
import { withOracles } from "./model/oracles";
import { readModel } from "./model/readModel";
import type { Subject } from "./run/subject";

export { isRefusal, isUnanswered, RaceError } from "../../api/typescript/src/errors";

/** The arguments of a run, with the numbers as they were written. */
export type ExactArguments = Arguments;

/** What answers a question about a run: the core that hosts it, or the store. */
export type RunSource = "cores" | "runs";

export function readNative({ document, origin }: Native): RcmDocument {
  const model = readModel(document);
  return { ...model, root: withOracles(withAfters(model.root, origin), origin) };
}

/** How a document is stored. */
export interface Storing {
  /** The revision that it follows; nothing: there must be no document of its name. */
  readonly onto?: number;
  /** It may have errors. */
  readonly draft?: boolean;
  readonly author: string;
}

/** Requests to the server that the page came from; `fetcher` is the browser's fetch, or a test's. Each answer is checked against its schema. */
export function createApi(fetcher: typeof fetch) {
  const transport = { origin: "", fetch: fetcher };
  const send = <T>(call: Call<T>): Promise<T> => request(transport, call);
  const documentAt = (name: string, revision: number): Promise<DocumentEntry> => send(calls.getRevision(name, revision));
  const supervision = (supervised: boolean) => (supervised ? { supervised } : undefined);
  return {
    health: (): Promise<Health> => send(calls.getHealth()),
    accounts: async (): Promise<readonly Account[]> => (await send(calls.listAccounts())).accounts,
    addAccount: (account: AccountCreate): Promise<Account> => send(calls.createAccount(account)),
    changeAccount: (name: string, change: AccountChange): Promise<Account> => send(calls.changeAccount(name, change)),
    removeAccount: async (name: string): Promise<void> => void (await send(calls.deleteAccount(name))),
    rules: async (): Promise<readonly Rule[]> => (await send(calls.getRules())).rules,
    documents: async (): Promise<readonly DocumentSummary[]> => {
      const all: DocumentSummary[] = [];
      for (let after: string | undefined = ""; after !== undefined; ) {
        const page: Documents = await send(calls.listDocuments({ after }));
        all.push(...page.documents);
        after = page.next;
      }
      return all;
    },
    document: (name: string): Promise<DocumentEntry> => send(calls.getDocument(name)),
    /** As it was in a revision. */
    documentAt,
    /** The same as a model, and where its states were placed. Throws for a draft. */
    modelAt: async (name: string, revision: number): Promise<{ readonly document: RcmDocument; readonly places: Places }> => {
      const { document } = await documentAt(name, revision);
      return { document: readModel(check(schema.native, { document, origin: {} }).document), places: placesIn(document["layout"]) };
    },
    /** The last revision as a run would execute it. Throws for a draft. */
    documentModel: async (name: string): Promise<RcmDocument> => readNative(await send(calls.getDocumentNative(name))),
    /** The last revision as it was sent, with the numbers as they were written (edit/exact.ts). */
    documentText: (name: string): Promise<string> => requestText(transport, calls.getDocument(name)),
    /** Stores the content as it is. */
    putDocument: (name: string, content: Blob | string, { onto, draft = false, author }: Storing): Promise<DocumentEntry> =>
      send(calls.putDocument(name, new RawJson(content), { draft, author, ifMatch: tagOf(onto), ifNoneMatch: onto === undefined ? "*" : undefined })),
    /** As a file for another server. */
    bundleText: (name: string): Promise<string> => requestText(transport, calls.getDocumentBundle(name)),
    /** Stores the document of a bundle, and says what it lacks. */
    installBundle: (name: string, content: Blob, { onto, author }: Storing): Promise<BundleInstalled> =>
      send(calls.installBundle(new RawJson(content), { as: name, author, ifMatch: tagOf(onto) })),
    /** `revision`: of the document that is branched; nothing: the last one. */
    branchDocument: (name: string, as: string, author: string, revision?: number): Promise<DocumentEntry> =>
      send(calls.branchDocument(name, { as, author, ...(revision !== undefined && { revision }) })),
    /** The newest first, at most 100; only those before `before`. */
    revisions: (name: string, before?: number): Promise<Revisions> => send(calls.listRevisions(name, { before })),
    /** Makes an earlier revision the next one, if `onto` is the last one. */
    restoreDocument: (name: string, revision: number, { onto, author }: { readonly onto: number; readonly author: string }): Promise<DocumentEntry> =>
      send(calls.restoreDocument(name, { revision, author }, { ifMatch: tagOf(onto) })),
    /** With all its revisions, the last of which must be `revision`. */
    deleteDocument: (name: string, revision: number): Promise<DocumentRemoved> => send(calls.deleteDocument(name, { ifMatch: tagOf(revision) })),
    /** With the document that it proposes. */
    proposal: (id: string): Promise<Proposal> => send(calls.getProposal(id)),
    /** It becomes the next revision of its document. */
    acceptProposal: (id: string, author: string): Promise<Proposal> => send(calls.acceptProposal(id, { author })),
    declineProposal: (id: string, author: string, reason: string): Promise<Proposal> => send(calls.declineProposal(id, reason === "" ? {} : { reason }, { author })),
    withdrawProposal: (id: string, author: string): Promise<Proposal> => send(calls.withdrawProposal(id, { author })),
    /** The breakpoints that a person keeps at a document. */
    breakpoints: async (name: string, author: string): Promise<readonly KeptBreakpoint[]> => (await send(calls.getDocumentBreakpoints(name, { author }))).breakpoints,
    keepBreakpoints: (name: string, author: string, breakpoints: readonly KeptBreakpoint[]): Promise<unknown> => send(calls.putDocumentBreakpoints(name, { breakpoints }, { author })),
    /** Replaces those that a person has set in a core. */
    setBreakpoints: (id: string, author: string, breakpoints: readonly Breakpoint[]): Promise<Core> => send(calls.setBreakpoints(id, { breakpoints }, { author })),
    force: (id: string, force: Exact<Force>): Promise<Core> => send(calls.forceCore(id, force)),
    /** The arguments that a run was made with, with the numbers as they were written. */
    runArguments: async (id: string, of: RunSource): Promise<ExactArguments> => {
      const text = await requestText(transport, of === "cores" ? calls.getCore(id) : calls.getRun(id));
      return (readExact(text) as unknown as { readonly arguments: ExactArguments }).arguments;
    },
    createCore: (document: string, args: ExactArguments): Promise<Core> => send(calls.createCore({ document, arguments: args })),
    coreModel: async (id: string): Promise<RcmDocument> => readNative(await send(calls.getCoreNative(id))),
    /** `supervised`: nothing of it moves while who begins it is away from the controls of the cell. */
    start: (id: string, supervised = false): Promise<Core> => send(calls.startCore(id, supervision(supervised))),
    pause: (id: string): Promise<Core> => send(calls.pauseCore(id)),
    /** The same; otherwise it stays as it was. */
    resume: (id: string, supervised = false): Promise<Core> => send(calls.resumeCore(id, supervision(supervised))),
    /** Lets an edit that waits for it reach the run. */
    confirmEdit: (id: string, revision: number): Promise<Core> => send(calls.confirmCoreEdit(id, { revision })),
    stop: (id: string): Promise<Core> => send(calls.stopCore(id)),
    step: (id: string, step: StepRequest): Promise<Core> => send(calls.stepCore(id, step)),
    setLive: (id: string, live: boolean): Promise<Core> => send(calls.setCoreLive(id, { live })),
    derivations: async (id: string, from: number, to: number, of: RunSource = "cores"): Promise<readonly TraceStep[]> =>
      (await send(of === "cores" ? calls.getDerivations(id, { from, to }) : calls.getRunDerivations(id, { from, to }))).steps,
    /** The run as it was at a moment. */
    past: (of: RunSource, id: string, { step, micro }: Wanted): Promise<Past> => send(of === "cores" ? calls.getPast(id, { step, micro }) : calls.getRunPast(id, { step, micro })),
    /** At most 100 of the stored runs, the newest first; `before`: only those with a smaller number. */
    runs: (document?: string, before?: number): Promise<Runs> => send(calls.listRuns({ document, before })),
    storedRun: (id: string): Promise<Run> => send(calls.getRun(id)),
    /** Stores the file of a run as a new one. */
    importRun: (file: string): Promise<Run> => send(calls.importRun(new RawJson(file))),
    /** Where two runs first differ, from a macro step on. */
    compareRuns: (id: string, other: string, from = 1): Promise<RunComparison> => send(calls.compareRun(id, { with: other, from })),
    /** A test of the run, as a file for `race test`. */
    runTest: (id: string): Promise<string> => requestText(transport, calls.getRunTest(id)),
    /** Where the file of a run can be loaded. */
    runFileAddress: (id: string): string => targetOf(calls.exportRun(id)),
    deleteCore: (id: string): Promise<Core> => send(calls.deleteCore(id)),
    deleteRun: async (id: string): Promise<void> => void (await send(calls.deleteRun(id))),
    /** The model that it began with. */
    runModel: async (id: string): Promise<RcmDocument> => readNative(await send(calls.getRunNative(id))),
    /** Where everything in the cell was while it ran. */
    samples: async (id: string): Promise<Samples> => (await send(calls.getRunSamples(id))).samples,
    /** Which pictures of cameras are kept of it, in order. */
    pictures: async (id: string): Promise<RunPictures["pictures"]> => (await send(calls.getRunPictures(id))).pictures,
    picture: (id: string, number: number): Promise<RunPicture> => send(calls.getRunPicture(id, number)),
    /** When macro steps began, and which states services had. */
    timing: (id: string, from: number, to: number): Promise<Timing> => send(calls.getRunTiming(id, { from, to })),
    journal: (id: string): Promise<Journal> => send(calls.getRunJournal(id)),
    /** As things are now, or as they were in a past micro step. */
    why: (of: RunSource, id: string, subject: Subject, before?: MicroStep): Promise<Why> => {
      const asked = { ...subject, step: before?.step, micro: before?.micro };
      return send(of === "cores" ? calls.getWhy(id, asked) : calls.getRunWhy(id, asked));
    },
    /** A code with which a phone is let in. */
    createPairing: (pairing: PairingCreate): Promise<PairingCreated> => send(calls.createPairing(pairing)),
    /** Calls an operation of a service that moves nothing. Rejects with a ServiceError if it answers an error. */
    callService: async (service: string, operation: string, kwargs: Readonly<Record<string, JsonValue>>): Promise<JsonValue> =>
      resultOf(service, operation, await send(calls.callService(service, { operation, kwargs }))),
    cell: (): Promise<Scene> => send(calls.getCell()),
    person: (): Promise<Person> => send(calls.getPerson()),
    command: (body: PersonCommand): Promise<Person> => send(calls.commandPerson(body)),
    /** The cell as it was at the start; with `database`, that, too. */
    resetCell: (database: boolean): Promise<Person> => send(calls.resetCell({ database })),
    /** Address of a file that the scene names. */
    cellFile: (file: string): string => targetOf(calls.getCellFile(file)),
  };
}

export type Api = ReturnType<typeof createApi>;
