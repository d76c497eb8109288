// The ports of child states that a part of a condition reads, so that the page can lead to them.
import { exitReferences } from "../model/exitReferences";
import { childPath } from "../model/model";
import { stateAt, type ModelTree } from "../model/modelTree";

/** Their addresses, in the order of the text. `path`: the state in whose scope the condition stands. */
export function portsRead(tree: ModelTree, path: string, condition: string): readonly string[] {
  const children = stateAt(tree, path)?.children ?? [];
  return exitReferences(condition).flatMap(({ child, port }) => {
    const node = children.find(({ name }) => name === child);
    return node === undefined ? [] : [`${childPath(path, node)}.${port}`];
  });
}
