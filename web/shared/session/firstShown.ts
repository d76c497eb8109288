// What is shown of a run when the page turns to it: another run of the same document is shown as the one before it was.
import { elementsById } from "../model/byId";
import { foldedAtFirst } from "../model/folding";
import type { RcmDocument } from "../model/model";
import { buildTree, type ModelTree } from "../model/modelTree";
import type { Session } from "./session";
import type { Shown } from "./view";

/** What the page has shown last: the model of a run of `document`, and what was shown of it. */
export interface LastShown {
  readonly document: string;
  readonly model: RcmDocument;
  readonly shown: Shown;
}

/** What the page shows now; if the model of the watched run has not arrived yet, what it has shown before (`last`). */
export function lastShown({ document, model }: Session, { focus, collapsed, detail }: Shown, last: LastShown | undefined): LastShown | undefined {
  return document === undefined || model === undefined ? last : { document, model, shown: { focus, collapsed, detail } };
}

/**
 * What `shown` is of the model `before`, of the model `after` an edit. A state is the one that has its id, or, where one of them
 * has no id, the one at its path. What is gone, or has no children any more, is neither entered nor collapsed. A composite that is
 * new is collapsed as in a model that is shown for the first time.
 */
export function followModel({ focus, collapsed, detail }: Shown, before: ModelTree, after: ModelTree): Shown {
  const byId = elementsById(after);
  const moved = (path: string): string | undefined => {
    const id = before.get(path)?.node.id;
    const found = id === undefined ? undefined : byId.get(id);
    if (found?.kind === "state") return found.path;
    return id === undefined || after.get(path)?.node.id === undefined ? path : undefined;
  };
  const follow = (path: string): readonly string[] => {
    const found = moved(path);
    return found !== undefined && (after.get(found)?.children.length ?? 0) > 0 ? [found] : [];
  };
  const old = new Set([...before.values()].flatMap(({ path, children }) => (children.length > 0 ? follow(path) : [])));
  const folded = foldedAtFirst(after).filter((path) => !old.has(path));
  return { focus: focus === undefined ? undefined : follow(focus)[0], collapsed: new Set([...[...collapsed].flatMap(follow), ...folded]), detail };
}

/** What is shown of the model of a run of `document`, if the page has shown `last` before. */
export function firstShown(tree: ModelTree, document: string | undefined, last: LastShown | undefined, detail: Shown["detail"]): Shown {
  if (last !== undefined && document === last.document) return { ...followModel(last.shown, buildTree(last.model.root), tree), detail };
  return { focus: undefined, collapsed: new Set(foldedAtFirst(tree)), detail };
}
