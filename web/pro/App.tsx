// The expert page: task tree to the left, canvas in the middle, properties to the right, run bar and derivation below.
import { lazy, Suspense } from "react";
import { watchedCore } from "../shared/session/session";
import { commandOf } from "../shared/session/shortcuts";
import { ModelCanvas } from "./canvas/ModelCanvas";
import { useTree } from "./canvas/useDrawing";
import { CellInset } from "./cell/CellInset";
import { run, session, useView, view } from "./client";
import { Drawer } from "./panels/Drawer";
import { DraftErrors } from "./panels/DraftErrors";
import { Interruption } from "./panels/Interruption";
import { WaitingEdit } from "./panels/WaitingEdit";
import { KeyHelp } from "./panels/KeyHelp";
import { PropertiesPanel } from "./panels/PropertiesPanel";
import { RunBar } from "./panels/RunBar";
import { TaskPanel } from "./panels/TaskPanel";
import { TopBar } from "./panels/TopBar";
import { ServicesView } from "./services/ServicesView";
import { useShortcuts } from "./useShortcuts";

const CellView = lazy(() => import("./cell/CellView").then(({ CellView }) => ({ default: CellView })));

function usePageKeys(): void {
  useShortcuts((shortcut) => {
    switch (shortcut) {
      case "search":
        document.getElementById("search")?.focus();
        return true;
      case "help":
        view.dispatch({ type: "help", shown: true });
        return true;
      case "escape":
        view.dispatch({ type: "escape" });
        return true;
    }
    const command = commandOf(shortcut, watchedCore(session.get()));
    if (command === undefined) return false;
    void run(command);
    return true;
  });
}

export function App() {
  const page = useView((v) => v.page);
  const tree = useTree();
  usePageKeys();
  return (
    <div className="app">
      <TopBar />
      <TaskPanel tree={tree} />
      <main className="workspace" id="workspace">
        {page === "task" && <ModelCanvas tree={tree} />}
        {page === "draft" && <DraftErrors />}
        {page === "services" && <ServicesView />}
        {page === "cell" && (
          <Suspense fallback={<div className="canvas-empty">Loading the cell…</div>}>
            <CellView />
          </Suspense>
        )}
      </main>
      <div className="right">
        <PropertiesPanel tree={tree} />
        {page === "task" && <CellInset />}
      </div>
      <footer className="foot">
        <WaitingEdit tree={tree} />
        <Interruption />
        <RunBar />
        <Drawer />
      </footer>
      <KeyHelp />
    </div>
  );
}
