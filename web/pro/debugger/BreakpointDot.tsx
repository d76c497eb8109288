// That a state, or a port of it, has breakpoints, in its row of the tree.
import type { Entry } from "../../shared/debugger/breakpoints";
import { breakpointMarks, markOfState, type BreakpointMark } from "../../shared/debugger/places";
import type { ModelTree } from "../../shared/model/modelTree";
import { useKept } from "./kept";
import { useShownTree } from "./target";

type Marks = ReadonlyMap<string, BreakpointMark>;
const kNone: Marks = new Map();
let made: { readonly tree: ModelTree; readonly entries: readonly Entry[]; readonly marks: Marks } | undefined;

/** Made once for all rows. */
function marksOf(tree: ModelTree | undefined, entries: readonly Entry[]): Marks {
  if (tree === undefined || entries.length === 0) return kNone;
  if (made?.tree !== tree || made.entries !== entries) made = { tree, entries, marks: breakpointMarks(tree, entries.map(({ breakpoint }) => breakpoint)) };
  return made.marks;
}

/** `closed`: the rows of what is within it are not shown. */
export function BreakpointDot({ path, closed }: { readonly path: string; readonly closed: boolean }) {
  const tree = useShownTree();
  const entries = useKept((now) => now.entries);
  const mark = markOfState(marksOf(tree, entries), path, closed);
  return mark === undefined ? null : <span className={`breakpoint-dot${mark.on ? "" : " is-off"}`} role="img" aria-label={mark.text} title={mark.text} />;
}
