// Left of the document that is edited: search and its states.
import type { ModelTree } from "../../shared/model/modelTree";
import { SearchBox } from "../panels/SearchBox";
import { StateTree } from "../panels/StateTree";

export function EditSide({ tree }: { readonly tree: ModelTree | undefined }) {
  return (
    <aside className="side side-left" aria-label="Document">
      <SearchBox tree={tree} />
      <StateTree tree={tree} />
    </aside>
  );
}
