// The expert page: task tree to the left, canvas in the middle, properties to the right, run bar and derivation below.
import { Suspense } from "react";
import { commandable } from "../shared/session/session";
import { commandOf, isMove, type Shortcut } from "../shared/session/shortcuts";
import { ModelCanvas } from "./canvas/ModelCanvas";
import { CellDock } from "./cell/CellDock";
import { session, useSession, useView, view } from "./client";
import { isPageCovered } from "./covered";
import { isDebugShortcut, runCommandOf } from "./debugger/actions";
import { DebugMenu } from "./debugger/DebugMenu";
import { ForceBar } from "./debugger/ForceBar";
import { ReachedBar } from "./debugger/ReachedBar";
import { DocumentsPanel } from "./documents/DocumentsPanel";
import { DropTarget } from "./documents/DropTarget";
import { isHelpShown, showHelp } from "./help/help";
import { HelpPanel } from "./help/HelpPanel";
import { Tour } from "./help/Tour";
import { EditPage } from "./edit/EditPage";
import { EditProperties } from "./edit/EditProperties";
import { EditSide } from "./edit/EditSide";
import { useEditedTree, useEditing } from "./edit/editing";
import { FoldButton } from "./layout/FoldButton";
import { toggleFolded, useFolded } from "./layout/panels";
import { Splitter } from "./layout/Splitter";
import { Carried } from "./live/Carried";
import { useRunTree } from "./live/runTree";
import { WaitingEdit } from "./live/WaitingEdit";
import { Drawer } from "./panels/Drawer";
import { Interruption } from "./panels/Interruption";
import { KeyHelp } from "./panels/KeyHelp";
import { LostServer } from "./panels/LostServer";
import { RestartedServer } from "./panels/RestartedServer";
import { OnDisplays } from "./panels/OnDisplays";
import { PersonWaitBar } from "./panels/PersonWaitBar";
import { ProblemBar } from "./panels/ProblemBar";
import { PastBanner } from "./past/PastBanner";
import { move, toPresent } from "./past/past";
import { PropertiesPanel } from "./panels/PropertiesPanel";
import { RunBar } from "./panels/RunBar";
import { command } from "./panels/startAsk";
import { Controls } from "./panels/Controls";
import { StoppedCell } from "./panels/StoppedCell";
import { StartAskBar } from "./panels/StartAskBar";
import { focusSearch } from "./panels/SearchBox";
import { TaskPanel } from "./panels/TaskPanel";
import { TopBar } from "./panels/TopBar";
import { showRuns } from "./runs/actions";
import { lateCell } from "./cell/lateCell";
import { RunsPanel } from "./runs/RunsPanel";
import { areProposalsShown, showProposals } from "./proposals/proposals";
import { ProposalsPanel } from "./proposals/ProposalsPanel";
import { AccountsPanel } from "./login/AccountsPanel";
import { LoginCover } from "./login/LoginCover";
import { PairPhone } from "./pairing/PairPhone";
import { ServicesView } from "./services/ServicesView";
import { StartCards } from "./start/StartCards";
import { useShortcuts } from "./useShortcuts";

const CellView = lateCell(() => Promise.resolve());

/** What moves a run on does so only on a page that shows it. */
const kStarts: ReadonlySet<Shortcut> = new Set(["lead", "micro", "macro"]);
/** The zoom keys are the canvas'. */
const kOfRuns: ReadonlySet<Shortcut> = new Set([...kStarts, "pause", "stop"]);

/** So long after the page has changed, a key that starts something may have been meant for the page before [ms]. */
const kSettling = 1000;
const settling = { page: view.get().page, since: -kSettling };
view.listen(() => {
  const { page } = view.get();
  if (page !== settling.page) Object.assign(settling, { page, since: performance.now() });
});

/** Whether a key moves a run: not while it is held, and not on a page that does not show the run, or did not a moment ago. */
const mayMove = (shortcut: Shortcut, held: boolean): boolean =>
  !held && !(kStarts.has(shortcut) && (settling.page === "edit" || isPageCovered() || performance.now() - settling.since < kSettling));

function usePageKeys(): void {
  useShortcuts((shortcut, held) => {
    switch (shortcut) {
      case "search":
        focusSearch();
        return true;
      case "documents":
        view.dispatch({ type: "documents", shown: true });
        return true;
      case "runs":
        showRuns(true);
        return true;
      case "fold_left":
      case "fold_right":
        if (!held) toggleFolded(shortcut === "fold_left" ? "left" : "right");
        return true;
      case "fold_below":
        if (!held) view.dispatch({ type: "toggle_drawer" });
        return true;
      case "follow":
        if (!held && view.get().page === "task") view.dispatch({ type: "follow", on: !view.get().follow });
        return true;
      case "help":
        view.dispatch({ type: "help", shown: true });
        return true;
      case "guide":
        if (!isHelpShown()) showHelp({ topic: "start" });
        return true;
      case "escape":
        if (isHelpShown()) showHelp(undefined);
        else if (areProposalsShown()) showProposals(undefined);
        else if (session.get().past !== undefined && !isPageCovered()) toPresent();
        else view.dispatch({ type: "escape" });
        return true;
    }
    if (isMove(shortcut)) {
      move(shortcut, held);
      return true;
    }
    if (isDebugShortcut(shortcut)) {
      if (shortcut === "breakpoint" ? !held : mayMove("lead", held)) runCommandOf(shortcut);
      return true;
    }
    if (!kOfRuns.has(shortcut)) return false;
    const wanted = mayMove(shortcut, held) ? commandOf(shortcut, commandable(session.get())) : undefined;
    if (wanted !== undefined) command(wanted);
    // The keys of runs are never the browser's: F5 does not load the page anew.
    return true;
  });
}

export function App() {
  const page = useView((v) => v.page);
  const manual = useView((v) => v.drawer === "manual");
  const run = useRunTree();
  const edited = useEditedTree();
  const document = useEditing((now) => now.document);
  const watched = useSession((s) => s.watched);
  const places = useSession((s) => s.places);
  const lost = useSession((s) => s.connection === "lost");
  const tree = page === "edit" ? edited : run;
  const isFolded = { left: useFolded("left"), right: useFolded("right") };
  usePageKeys();
  return (
    <div className={`app${lost ? " is-lost" : ""}`}>
      <LostServer />
      <RestartedServer />
      <TopBar />
      <StoppedCell />
      <Controls />
      <PastBanner />
      {!isFolded.left && (page === "edit" ? <EditSide tree={tree} /> : <TaskPanel tree={tree} />)}
      <main className="workspace" id="workspace">
        <Splitter panel="left" at="right" folds="left" />
        <FoldButton panel="left" />
        {page === "task" && <ModelCanvas subject={`run ${watched ?? ""}`} tree={tree} places={places} nothing={watched === undefined ? <StartCards /> : "Loading the run…"} />}
        {page === "task" && <CellDock at="half" />}
        {page === "edit" && <EditPage tree={tree} document={document} />}
        {page === "services" && <ServicesView />}
        {page === "cell" && (
          <Suspense fallback={<div className="canvas-empty">Loading the cell…</div>}>
            <CellView />
          </Suspense>
        )}
        <Carried />
        <Splitter panel="right" at="left" folds="right" />
        <FoldButton panel="right" />
      </main>
      {!isFolded.right && (
        <div className="right">
          {page === "edit" ? <EditProperties tree={tree} /> : <PropertiesPanel tree={tree} />}
          {page === "task" && <CellDock at="column" />}
        </div>
      )}
      <footer className="foot">
        <ProblemBar />
        <WaitingEdit />
        <Interruption />
        <PersonWaitBar />
        <OnDisplays />
        <ForceBar />
        <ReachedBar />
        <StartAskBar />
        <RunBar />
        {(page !== "edit" || manual) && <Drawer />}
      </footer>
      <DebugMenu />
      <KeyHelp />
      <HelpPanel />
      <Tour />
      <DocumentsPanel />
      <RunsPanel />
      <ProposalsPanel />
      <PairPhone />
      <AccountsPanel />
      <LoginCover />
      <DropTarget />
    </div>
  );
}
