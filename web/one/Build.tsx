// The view in which an application is built: the skills, the tasks, and what is selected.
import { useEffect, useState } from "react";
import { SkillLibrary } from "./library/SkillLibrary";
import { useEditing } from "./editing";
import { handleKey } from "./keys";
import { everyStep, useApplication, useSelected } from "./model";
import { StepPanel } from "./step/StepPanel";
import { TaskPanel } from "./step/TaskPanel";
import { Tasks } from "./line/Tasks";
import { closeSheet } from "./closeSheet";
import { liesOver, useSheet } from "./sheet";
import { texts } from "./texts";

const t = texts.build;

export function Build({ name }: { readonly name: string }) {
  const application = useApplication();
  const unreadable = useEditing((now) => now.session?.unreadable);
  const selected = useSelected();
  const sheet = useSheet();
  const [panel, setPanel] = useState<HTMLElement | null>(null);
  useEffect(() => {
    addEventListener("keydown", handleKey);
    return () => removeEventListener("keydown", handleKey);
  }, []);
  useEffect(() => {
    if (sheet === "panel" && panel !== null && liesOver(panel)) panel.focus();
  }, [sheet, panel]);
  if (unreadable !== undefined) return <main className="build-empty"><h2>{t.unreadable(name)}</h2><p>{unreadable.message}</p></main>;
  if (application === undefined) return <main className="build-empty"><p role="status">{t.opening(name)}</p></main>;
  const canAdd = application.isEditable || everyStep(application).some(({ inner }) => inner?.form === "editable");
  return (
    <div className={canAdd ? "build" : "build is-read"} data-sheet={sheet ?? "none"}>
      {canAdd && <SkillLibrary />}
      <Tasks application={application} />
      <aside className="panel" aria-label={t.selected} tabIndex={-1} ref={setPanel}>
        <button type="button" className="plain sheet-close" aria-label={t.close} onClick={closeSheet}>
          ✕
        </button>
        {selected === undefined ? (
          <p className="quiet">{t.nothing}</p>
        ) : selected.isTask ? (
          <TaskPanel key={selected.step.id} step={selected.step} line={selected.line} isEditable={application.isEditable} />
        ) : (
          <StepPanel key={selected.step.id} step={selected.step} line={selected.line} application={application} />
        )}
      </aside>
    </div>
  );
}
