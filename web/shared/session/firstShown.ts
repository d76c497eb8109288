// What is shown of a run when the page turns to it: another run of the same document is shown as the one before it was.
import { elementsById } from "../model/byId";
import { foldedAtFirst } from "../model/folding";
import { buildTree, type ModelTree } from "../model/modelTree";
import { watchedCore, type Session } from "./session";
import type { Shown } from "./view";

/**
 * What `shown` is of the model `before`, of the model `after` an edit. A state is the one that has its id, or, where one of them
 * has no id, the one at its path. What is gone, or has no children any more, is neither entered nor collapsed.
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
  return { focus: focus === undefined ? undefined : follow(focus)[0], collapsed: new Set([...collapsed].flatMap(follow)), detail };
}

/** What is shown of the model of the watched run; `last` and `shown` are as they were before the page turned to it. */
export function firstShown(tree: ModelTree, session: Session, last: Session, shown: Shown): Shown {
  const document = watchedCore(session)?.document;
  const again = document !== undefined && document === watchedCore(last)?.document;
  if (again && last.model !== undefined) return followModel(shown, buildTree(last.model.root), tree);
  return { focus: undefined, collapsed: new Set(foldedAtFirst(tree)), detail: shown.detail };
}
