// The expert page: task tree to the left, canvas in the middle, properties to the right, run bar and derivation below.
import { lazy, Suspense, useEffect } from "react";
import { commandOfKey } from "../shared/run/controls";
import { watchedCore } from "../shared/session/session";
import { ModelCanvas } from "./canvas/ModelCanvas";
import { useTree } from "./canvas/useDrawing";
import { CellInset } from "./cell/CellInset";
import { run, session, useView, view } from "./client";
import { Drawer } from "./panels/Drawer";
import { PropertiesPanel } from "./panels/PropertiesPanel";
import { RunBar } from "./panels/RunBar";
import { TaskPanel } from "./panels/TaskPanel";
import { TopBar } from "./panels/TopBar";
import { ServicesView } from "./services/ServicesView";

const CellView = lazy(() => import("./cell/CellView").then(({ CellView }) => ({ default: CellView })));

function useRunKeys(): void {
  useEffect(() => {
    const press = (event: KeyboardEvent) => {
      if (event.ctrlKey && event.key === "f") {
        event.preventDefault();
        document.getElementById("search")?.focus();
        return;
      }
      if (event.key === "Escape") view.dispatch({ type: "select", selection: undefined });
      if (event.ctrlKey || event.altKey || event.metaKey) return;
      const command = commandOfKey(event.key, event.shiftKey, watchedCore(session.get()));
      if (command === undefined) return;
      event.preventDefault();
      void run(command);
    };
    addEventListener("keydown", press);
    return () => removeEventListener("keydown", press);
  }, []);
}

export function App() {
  const page = useView((v) => v.page);
  const tree = useTree();
  useRunKeys();
  return (
    <div className="app">
      <TopBar />
      <TaskPanel tree={tree} />
      <main className="stage" id="stage">
        {page === "task" && <ModelCanvas tree={tree} />}
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
        <RunBar />
        <Drawer />
      </footer>
    </div>
  );
}
