// Above: the way back to all applications, build and run, undo and redo, and the way to the expert page.
import { ThemeButton } from "../pro/theme/ThemeButton";
import { applicationTitle } from "../shared/timeline/read";
import { useSession } from "./client";
import { takeBack, useEditing, useTree } from "./editing";
import { leaveGuide } from "./guide/steps";
import { PairPhone } from "./PairPhone";
import { go, usePlace } from "./place";
import { texts } from "./texts";

const t = texts.frame;

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
        <b>{t.brand.name}</b> {t.brand.page}
      </a>
      {edit !== undefined && guide === undefined && (
        <>
          <h1>{title}</h1>
          <nav aria-label={t.views}>
            <button type="button" aria-current={view === "build" ? "page" : undefined} onClick={() => go({ view: "build" })}>
              {t.build}
            </button>
            <button type="button" aria-current={view === "run" ? "page" : undefined} onClick={() => go({ view: "run" })}>
              {t.run}
            </button>
          </nav>
          <UndoButtons />
        </>
      )}
      <span className="head-end">
        <a href={edit === undefined ? "/pro/" : `/pro/?edit=${encodeURIComponent(edit)}`}>{edit === undefined ? t.pro : t.openInPro}</a>
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
    <span className="undo" role="group" aria-label={t.changes}>
      <button type="button" className="plain" aria-label={t.undo} title={t.undoKeys} aria-keyshortcuts="Control+Z" disabled={depths?.undo === 0} onClick={() => takeBack("undo")}>
        ↶
      </button>
      <button type="button" className="plain" aria-label={t.redo} title={t.redoKeys} aria-keyshortcuts="Control+Y" disabled={(depths?.redo ?? 0) === 0} onClick={() => takeBack("redo")}>
        ↷
      </button>
    </span>
  );
}

function Connection() {
  const connection = useSession((s) => s.connection);
  const waiting = useEditing((now) => now.session?.pending.length ?? 0);
  const text = { connecting: t.connecting, open: waiting > 0 ? t.saving : t.saved, lost: t.connectionLost }[connection];
  const edit = usePlace((place) => place.edit);
  return (
    <span className={`connection is-${connection}`} role="status" aria-label={t.connection}>
      {edit === undefined && connection === "open" ? t.connected : text}
    </span>
  );
}
