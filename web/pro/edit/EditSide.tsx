// Left of the document that is edited: search, what can be added, the library, the services, and its states; or its history, or the coverage of its tests, with its states.
import type { ModelTree } from "../../shared/model/modelTree";
import { CoveragePanel } from "../coverage/CoveragePanel";
import { useCoverageShown } from "../coverage/coverage";
import { BreakpointsPanel } from "../debugger/BreakpointsPanel";
import { SearchBox } from "../panels/SearchBox";
import { StateTree } from "../panels/StateTree";
import { useHistory } from "../versions/history";
import { VersionsPanel } from "../versions/VersionsPanel";
import { Library } from "./Library";
import { Palette } from "./Palette";
import { ServicePalette } from "./ServicePalette";

export function EditSide({ tree }: { readonly tree: ModelTree | undefined }) {
  const history = useHistory((now) => now.shown);
  const coverage = useCoverageShown();
  return (
    <aside className="side side-left" aria-label="Document">
      {history ? (
        <VersionsPanel />
      ) : coverage ? (
        <CoveragePanel />
      ) : (
        <>
          <SearchBox tree={tree} />
          <Palette />
          <Library />
          <ServicePalette />
          <BreakpointsPanel tree={tree} />
        </>
      )}
      <StateTree tree={tree} />
    </aside>
  );
}
