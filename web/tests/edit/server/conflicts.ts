// Whether an operation keeps its meaning although others have edited the document meanwhile (core/edit/conflicts.h).
import type { EditInsert, EditMove, EditSet } from "../../../generated/messages";
import type { Operation } from "../../../shared/edit/apply";
import { isBelow, type Tree } from "../../../shared/edit/tree";
import { entryOf, isObject } from "../../../shared/json";
import type { LogEntry } from "./log";

/** Why an edit was not accepted, and the edit of another that is the reason, if there is one. */
export interface Rejection {
  readonly path: string;
  readonly code: string;
  readonly author?: string;
  readonly revision?: number;
}

/** What an edit is: its author has seen `base`; an undo takes back the edit `base`, a redo the undo `base`. */
export interface Request {
  readonly of: LogEntry["kind"];
  readonly base: number;
  readonly author: string;
}

export function insertedId({ node }: EditInsert): string {
  const meta = entryOf(node, "meta");
  const id = isObject(meta) ? entryOf(meta, "id") : undefined;
  return typeof id === "string" ? id : "";
}

/** The element whose content or place an operation changes; nothing for one that only takes away. */
function changedBy(operation: Operation): string {
  if (operation.op === "insert") return insertedId(operation);
  return operation.op === "remove" ? "" : operation.id;
}

const because = ({ author, revision }: LogEntry, path: string): Rejection => ({ path, code: "conflict", author, revision });

export class Conflicts {
  constructor(
    private readonly log: readonly LogEntry[],
    private readonly tree: Tree,
    private readonly request: Request,
  ) {}

  private counts(entry: LogEntry): boolean {
    const { of, base, author } = this.request;
    if (entry.revision <= base) return false;
    if (of === "undo") return entry.inEffect;
    if (of === "redo") return entry.inEffect && entry.author !== author;
    return entry.author !== author && (entry.inEffect || entry.partner <= base);
  }

  private latest(matches: (entry: LogEntry) => boolean): LogEntry | undefined {
    return this.log.filter((entry) => this.counts(entry) && matches(entry)).at(-1);
  }

  /** The latest that counts of which `matches` holds for an operation and its inverse. */
  private find(matches: (operation: Operation, inverse: Operation | undefined) => boolean): LogEntry | undefined {
    return this.latest(({ edit, inverse }) => edit.operations.some((operation, i) => matches(operation, inverse.operations.at(-1 - i))));
  }

  private changeBelow(id: string): LogEntry | undefined {
    return this.find((operation, inverse) => {
      const at = changedBy(operation);
      if (at !== "" && isBelow(this.tree, id, at)) return true;
      // What was taken out of there would have no way back.
      const isPlaced = inverse?.op === "insert" || inverse?.op === "move";
      return this.request.of !== "change" && isPlaced && isBelow(this.tree, id, inverse.parent);
    });
  }

  private moveOf(id: string): LogEntry | undefined {
    return this.find((operation) => operation.op === "move" && operation.id === id);
  }

  private setOf(set: EditSet): LogEntry | undefined {
    return this.find((operation) => operation.op === "set" && operation.id === set.id && operation.field === set.field && operation.key === set.key);
  }

  private replacementOf(id: string): LogEntry | undefined {
    return this.latest((entry) => entry.inserted.includes(id));
  }

  /** Of what an undo or redo puts back: the state in which it was, or some of it, was made anew. */
  private replaced(operation: EditInsert | EditMove): Rejection | undefined {
    const { of, base } = this.request;
    if (of === "change") return undefined;
    const parent = this.replacementOf(operation.parent);
    if (parent !== undefined) return because(parent, "parent");
    const removed = this.log.find(({ revision }) => revision === base)?.removed ?? [];
    const ids = operation.op === "insert" ? [...removed].sort() : [];
    const entry = ids.map((id) => this.replacementOf(id)).find((each) => each !== undefined);
    return entry && because(entry, "node");
  }

  /** Why `operation`, about to be applied, would not do what its author meant. */
  of(operation: Operation): Rejection | undefined {
    const found = (entry: LogEntry | undefined, path: string) => (entry === undefined ? undefined : because(entry, path));
    const replaced = operation.op === "insert" || operation.op === "move" ? this.replaced(operation) : undefined;
    if (replaced !== undefined) return replaced;
    if (operation.op === "remove") return found(this.changeBelow(operation.id) ?? this.replacementOf(operation.id), "id");
    if (operation.op === "move") return found(this.moveOf(operation.id), "id") ?? found(this.replacementOf(operation.id), "id");
    if (operation.op === "set" && this.request.of !== "change") return found(this.setOf(operation), "field") ?? found(this.replacementOf(operation.id), "id");
    return undefined;
  }

  /** Names the edit because of which `operation` was refused, if one is known. */
  explain({ code, path }: Rejection, operation: Operation): Rejection {
    const gone = (id: string): Rejection | undefined => {
      const entry = this.log.filter(({ removed }) => removed.includes(id)).at(-1);
      return entry === undefined || this.tree.elements.has(id) ? undefined : because(entry, path);
    };
    const cause = (): Rejection | undefined => {
      if (code === "not_found" && path === "parent" && (operation.op === "insert" || operation.op === "move")) return gone(operation.parent);
      if (code === "not_found" && path === "id" && operation.op !== "insert") return gone(operation.id);
      if (code !== "not_accepted" || path !== "parent" || operation.op !== "move") return undefined;
      const entry = this.find((other) => other.op === "move" && isBelow(this.tree, operation.id, other.id) && isBelow(this.tree, other.id, operation.parent));
      return entry === undefined ? undefined : because(entry, "parent");
    };
    return cause() ?? { code, path };
  }
}
