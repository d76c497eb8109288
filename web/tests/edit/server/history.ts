// The history of a document on a simulated server: orders edits, rebases or rejects them, takes them back (core/edit/history.h).
// The server's has the same test vectors (vectors.test.ts).
import type { Edit } from "../../../generated/messages";
import { apply, type Operation } from "../../../shared/edit/apply";
import { Refusal } from "../../../shared/edit/refusal";
import { elementOf, subtree, type Tree } from "../../../shared/edit/tree";
import { Conflicts, insertedId, type Rejection, type Request } from "./conflicts";
import type { LogEntry } from "./log";
import { Positions, type Departure, type Place, type Spot } from "./positions";

interface Step {
  readonly revision: number;
  /** It was rejected; nothing was taken back since. */
  isBlocked: boolean;
}

interface Stacks {
  undo: Step[];
  redo: Step[];
}

/** What is done of an edit so far. */
interface Progress {
  readonly tree: Tree;
  readonly positions: Positions;
  readonly operations: readonly Operation[];
  readonly inverses: readonly Operation[];
  readonly departures: readonly Departure[];
  readonly inserted: readonly string[];
  readonly removed: readonly string[];
}

interface Rebase extends Request {
  readonly edit: Edit;
  /** Of the edit that it takes back. */
  readonly departures?: readonly Departure[];
  readonly since: Departure;
}

const isRejection = (value: object): value is Rejection => "code" in value;

const placeOf = (operation: Operation): Place | undefined => (operation.op === "insert" || operation.op === "move" ? operation : undefined);

/** Refused by the tree, which says why. */
function isImpossible(tree: Tree, operation: Operation): boolean {
  const leaving = operation.op === "remove" || operation.op === "move" ? operation.id : undefined;
  if (leaving !== undefined && tree.elements.get(leaving)?.list === undefined) return true;
  const place = placeOf(operation);
  return place !== undefined && ((leaving !== undefined && place.after === leaving) || (place.parent !== "" && !tree.elements.has(place.parent)));
}

function placed(operation: Operation, { parent, list, after }: Place): Operation {
  const place = { parent, list, ...(after !== undefined && { after }) };
  if (operation.op === "insert") return { op: "insert", ...place, node: operation.node };
  return operation.op === "move" ? { op: "move", id: operation.id, ...place } : operation;
}

export class History {
  readonly log: LogEntry[] = [];
  private positions = Positions.none;
  private readonly stacks = new Map<string, Stacks>();

  constructor(
    public tree: Tree,
    public revision = 0,
  ) {}

  /** An edit by somebody who has seen revision `base` and their own edits after it. */
  apply(author: string, base: number, edit: Edit): LogEntry | Rejection {
    if (base > this.revision) return { path: "", code: "out_of_range" };
    const result = this.execute({ of: "change", base, author, edit, since: this.entryOf(base)?.lastDeparture ?? 0 });
    if (isRejection(result)) return result;
    const entry = this.commit(result, author, "change", 0);
    const stacks = this.stacksOf(author);
    stacks.redo = [];
    stacks.undo.push({ revision: entry.revision, isBlocked: false });
    return entry;
  }

  undo(author: string): LogEntry | Rejection {
    return this.takeBack(author, "undo");
  }

  redo(author: string): LogEntry | Rejection {
    return this.takeBack(author, "redo");
  }

  stacksOf(author: string): Stacks {
    const stacks = this.stacks.get(author) ?? { undo: [], redo: [] };
    this.stacks.set(author, stacks);
    return stacks;
  }

  private entryOf(revision: number): LogEntry | undefined {
    return this.log.find((entry) => entry.revision === revision);
  }

  private takeBack(author: string, kind: "undo" | "redo"): LogEntry | Rejection {
    const own = this.stacksOf(author);
    const step = own[kind].filter(({ isBlocked }) => !isBlocked).at(-1);
    const taken = step && this.entryOf(step.revision);
    if (step === undefined || taken === undefined) return { path: "", code: "not_found" };
    const { revision, inverse, departures, lastDeparture } = taken;
    const result = this.execute({ of: kind, base: revision, author, edit: inverse, departures, since: lastDeparture });
    if (isRejection(result)) {
      step.isBlocked = true;
      return result;
    }
    own[kind] = own[kind].filter((each) => each !== step);
    for (const { undo, redo } of this.stacks.values()) for (const each of [...undo, ...redo]) each.isBlocked = false;
    const entry = this.commit(result, author, kind, revision);
    if (kind === "undo") {
      taken.inEffect = entry.inEffect = false;
      taken.partner = entry.revision;
      entry.partner = revision;
    }
    (kind === "undo" ? own.redo : own.undo).push({ revision: entry.revision, isBlocked: false });
    return entry;
  }

  private commit(progress: Progress, author: string, kind: LogEntry["kind"], of: number): LogEntry {
    const { tree, positions, operations, inverses, departures, inserted, removed } = progress;
    this.tree = tree;
    this.positions = positions;
    const entry: LogEntry = {
      revision: ++this.revision, author, kind, of, edit: { operations }, inverse: { operations: [...inverses].reverse() },
      departures, lastDeparture: positions.last, inserted, removed, inEffect: true, partner: 0,
    };
    this.log.push(entry);
    return entry;
  }

  private execute(request: Rebase): Progress | Rejection {
    const { operations } = request.edit;
    let done: Progress = { tree: this.tree, positions: this.positions, operations: [], inverses: [], departures: [], inserted: [], removed: [] };
    for (const [i, operation] of operations.entries()) {
      const returning = request.departures?.at(-1 - i) ?? 0;
      const next = this.executeOne(request, operation, returning, done);
      if (isRejection(next)) return { ...next, path: `operations/${i}/${next.path}` };
      done = next;
    }
    return done;
  }

  private executeOne(request: Rebase, operation: Operation, returning: Departure, done: Progress): Progress | Rejection {
    const { tree } = done;
    const conflicts = new Conflicts(this.log, tree, request);
    const conflict = conflicts.of(operation);
    if (conflict !== undefined) return conflict;
    const moved = isImpossible(tree, operation) ? { positions: done.positions, departure: 0 } : this.leave(operation, done);
    const place = isImpossible(tree, operation) ? undefined : placeOf(operation);
    const spot = place && this.spot(moved.positions, place, returning, request.since);
    if (place !== undefined && spot === undefined) return { path: "after", code: "not_found" };
    const concrete = spot === undefined ? operation : placed(operation, spot.place);
    const result = apply(tree, { operations: [concrete] });
    if (result instanceof Refusal) return conflicts.explain({ code: result.code, path: result.path.replace("operations/0/", "") }, operation);
    const removed = concrete.op === "remove" ? subtree(tree, concrete.id) : [];
    const entering = concrete.op === "insert" ? insertedId(concrete) : concrete.op === "move" ? concrete.id : "";
    const left = moved.positions.store(removed, moved.departure);
    const entered = spot === undefined ? left : left.enter(spot, entering);
    return {
      tree: result.tree,
      positions: spot?.isReturn === true ? entered.restore(returning) : entered,
      operations: [...done.operations, concrete],
      inverses: [...done.inverses, ...result.inverse.operations],
      departures: [...done.departures, moved.departure],
      inserted: concrete.op === "insert" ? [...done.inserted, ...subtree(result.tree, entering)] : done.inserted,
      removed: [...done.removed, ...removed],
    };
  }

  /** What an operation takes from its place, and the lists that it touches. */
  private leave(operation: Operation, { tree, positions }: Progress): { readonly positions: Positions; readonly departure: Departure } {
    const place = placeOf(operation);
    const element = operation.op === "remove" || operation.op === "move" ? elementOf(tree, operation.id) : undefined;
    let next = positions;
    if (element?.list !== undefined) next = next.sync(tree, element.parent, element.list);
    if (place !== undefined) next = next.sync(tree, place.parent, place.list);
    if (element?.list === undefined) return { positions: next, departure: 0 };
    next = next.leave(element.parent, element.list, element.id);
    return { positions: next, departure: next.last };
  }

  private spot(positions: Positions, place: Place, returning: Departure, since: Departure): Spot | undefined {
    return positions.spotOf(place.parent, place.list, returning) ?? positions.spot(place, since, this.positions.last);
  }
}
