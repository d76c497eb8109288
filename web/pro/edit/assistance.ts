// Asks a worker which operations no service can accept at a place of the document that is edited. The task goes to it once for each change.
import { spotOf, taskOf, type Spot, type Task } from "../../shared/code/assistance";
import type { CodePlace } from "../../shared/code/scope";
import type { KnownService } from "../../shared/code/services";
import type { Tree } from "../../shared/edit/tree";
import type { Answer, Question } from "../code/orchestration.worker";
import { editedDocument } from "./editing";
import { knownServicesNow } from "./forms/useKnownServices";

export type Unreachable = ReadonlyMap<string, string>;

const kNothing: Unreachable = new Map();

/** What is not known by then is not marked [ms]. */
const kPatience = 1500;

let worker: Worker | undefined;
let task: Task | undefined;
let made: { readonly tree: Tree; readonly services: readonly KnownService[]; readonly task: Task } | undefined;
let last = 0;
const waiting = new Map<number, (unreachable: Unreachable) => void>();

/** The next question begins anew with a worker: this one does not load, or has failed. */
function giveUp(): void {
  worker?.terminate();
  [worker, task] = [undefined, undefined];
  for (const answer of waiting.values()) answer(kNothing);
  waiting.clear();
}

function started(): Worker {
  if (worker !== undefined) return worker;
  const made = new Worker(new URL("../code/orchestration.worker.ts", import.meta.url), { type: "module" });
  made.addEventListener("message", ({ data }: MessageEvent<Answer>) => {
    waiting.get(data.number)?.(data.unreachable);
    waiting.delete(data.number);
  });
  made.addEventListener("error", giveUp);
  worker = made;
  return made;
}

/** Made once for a document, as a key waits for it. */
function taskNow(tree: Tree): Task {
  const services = knownServicesNow();
  if (made?.tree !== tree || made.services !== services) made = { tree, services, task: taskOf(tree, services, task) };
  return made.task;
}

/** Gives the worker the document as it is now, if it has another one. */
function post(question: Omit<Question, "number">, now: Task): number {
  const number = ++last;
  const isNew = now !== task || worker === undefined;
  started().postMessage({ number, ...question, ...(isNew && { task: now }) } satisfies Question);
  task = now;
  return number;
}

/** Lets the worker get ready for questions about the document as it is now. */
export function prepareAssistance(): void {
  const tree = editedDocument();
  const now = tree && taskNow(tree);
  if (now !== undefined && (now !== task || worker === undefined)) post({}, now);
}

/** The operations, as `svc.key.operation`, and why no service can accept them there; `before`: the text in front of that place. */
export function unreachableAt(place: CodePlace, before: string): Promise<Unreachable> {
  const tree = editedDocument();
  if (tree?.elements.has(place.id) !== true) return Promise.resolve(kNothing);
  const now = taskNow(tree);
  const spot: Spot | undefined = spotOf(tree, now, place, before);
  if (spot === undefined) return Promise.resolve(kNothing);
  return new Promise((resolve) => {
    const number = post({ spot }, now);
    waiting.set(number, resolve);
    setTimeout(() => {
      if (waiting.delete(number)) resolve(kNothing);
    }, kPatience);
  });
}
