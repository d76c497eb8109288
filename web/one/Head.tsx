// Above: the way back to all applications, build and run, undo and redo, and the way to the expert page.
import { ThemeButton } from "../pro/theme/ThemeButton";
import { applicationTitle } from "../shared/timeline/read";
import { useSession } from "./client";
import { takeBack, useEditing, useTree } from "./editing";
import { leaveGuide } from "./guide/steps";
import { PairPhone } from "./PairPhone";
import { go, usePlace } from "./place";

export function Head() {
  const edit = usePlace((place) => place.edit);
  const view = usePlace((place) => place.view);
  const guide = usePlace((place) => place.guide);
  const tree = useTree();
  const title = tree === undefined ? edit : (applicationTitle(tree) ?? edit);
  return (
    <header className="head">
      <a
        className="brand"
        href="/one/"
        onClick={(event) => {
          event.preventDefault();
          leaveGuide();
        }}
      >
        <b>RACE</b> One
      </a>
      {edit !== undefined && guide === undefined && (
        <>
          <h1>{title}</h1>
          <nav aria-label="Views">
            <button type="button" aria-current={view === "build" ? "page" : undefined} onClick={() => go({ view: "build" })}>
              Build
            </button>
            <button type="button" aria-current={view === "run" ? "page" : undefined} onClick={() => go({ view: "run" })}>
              Run
            </button>
          </nav>
          <UndoButtons />
        </>
      )}
      <span className="head-end">
        <a href={edit === undefined ? "/pro/" : `/pro/?edit=${encodeURIComponent(edit)}`}>{edit === undefined ? "RACE Pro" : "Open in Pro"}</a>
        <PairPhone />
        <Connection />
        <ThemeButton />
      </span>
    </header>
  );
}

function UndoButtons() {
  const depths = useEditing((now) => now.session?.depths);
  return (
    <span className="undo" role="group" aria-label="Changes">
      <button type="button" className="plain" aria-label="Undo" title="Undo (Ctrl+Z)" aria-keyshortcuts="Control+Z" disabled={depths?.undo === 0} onClick={() => takeBack("undo")}>
        ↶
      </button>
      <button type="button" className="plain" aria-label="Redo" title="Redo (Ctrl+Y)" aria-keyshortcuts="Control+Y" disabled={(depths?.redo ?? 0) === 0} onClick={() => takeBack("redo")}>
        ↷
      </button>
    </span>
  );
}

function Connection() {
  const connection = useSession((s) => s.connection);
  const waiting = useEditing((now) => now.session?.pending.length ?? 0);
  const text = { connecting: "Connecting", open: waiting > 0 ? "Saving…" : "Saved", lost: "Connection lost" }[connection];
  const edit = usePlace((place) => place.edit);
  return (
    <span className={`connection is-${connection}`} role="status" aria-label="Connection">
      {edit === undefined && connection === "open" ? "Connected" : text}
    </span>
  );
}
