// Left panel: search, what runs now, and the tree of states.
import type { ModelTree } from "../../shared/model/modelTree";
import { BreakpointsPanel } from "../debugger/BreakpointsPanel";
import { RunningNow } from "./RunningNow";
import { SearchBox } from "./SearchBox";
import { StateTree } from "./StateTree";

export function TaskPanel({ tree }: { readonly tree: ModelTree | undefined }) {
  return (
    <aside className="side side-left" aria-label="Task">
      <SearchBox tree={tree} />
      <RunningNow tree={tree} />
      <BreakpointsPanel tree={tree} />
      <StateTree tree={tree} />
    </aside>
  );
}
