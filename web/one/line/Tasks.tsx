// The tasks of an application with their time lines.
import { useState, type SubmitEvent } from "react";
import { addTask } from "../../shared/timeline/changes/add";
import type { Application } from "../../shared/timeline/read";
import { perform, useEditing } from "../editing";
import { useProblems, useUntaught } from "../model";
import { go } from "../place";
import { select } from "../select";
import { showSheet } from "../sheet";
import { UntaughtPose } from "../step/Untaught";
import { useDragged } from "./drag";
import { TaskCard } from "./TaskCard";
import { texts } from "../texts";

const t = texts.line;

export function Tasks({ application }: { readonly application: Application }) {
  const problems = useProblems();
  const { tasks, isEditable, root } = application;
  const errors = useEditing((now) => now.session?.errors.length ?? 0);
  const [untaught] = useUntaught();
  return (
    <main className="tasks" aria-label={t.tasks}>
      <div className="tasks-head">
        <h2>{t.tasks}</h2>
        <ReadyText problems={problems.length} errors={errors} first={problems[0]?.step} isEmpty={tasks.length === 0} />
      </div>
      {untaught !== undefined && <UntaughtPose untaught={untaught} />}
      {!isEditable && (
        <p className="notice">{t.rich(root.reason ?? "")}</p>
      )}
      {tasks.map((task, index) => (
        <TaskCard key={task.id} task={task} index={index} count={tasks.length} problems={problems} />
      ))}
      {isEditable && <NewTask isFirst={tasks.length === 0} at={tasks.length} root={root.id} />}
      <DragGhost />
    </main>
  );
}

interface ReadyProps {
  readonly problems: number;
  readonly errors: number;
  readonly first: string | undefined;
  readonly isEmpty: boolean;
}

/** Whether it can be started, and the way there. */
function ReadyText({ problems, errors, first, isEmpty }: ReadyProps) {
  if (isEmpty) return null;
  if (problems > 0 && first !== undefined)
    return (
      <button type="button" className="todo" onClick={() => select(first)}>
        {t.missing(problems)}
      </button>
    );
  if (errors > 0) return <p className="todo is-text">{t.hasErrors}</p>;
  return (
    <button type="button" className="main" onClick={() => go({ view: "run" })}>
      {t.ready}
    </button>
  );
}

function NewTask({ isFirst, at, root }: { readonly isFirst: boolean; readonly at: number; readonly root: string }) {
  const [asks, setAsks] = useState<boolean>();
  const [title, setTitle] = useState("");
  const make = (event: SubmitEvent) => {
    event.preventDefault();
    const id = perform((tree, supplies) => addTask(tree, root, at, title.trim() === "" ? t.taskWish(at + 1) : title, supplies));
    if (id === undefined) return;
    select(id, false);
    setAsks(false);
    setTitle("");
    showSheet("library");
  };
  if (!isFirst && asks !== true)
    return (
      // After the form, it has the focus again.
      <button type="button" className="add-task" autoFocus={asks === false} onClick={() => setAsks(true)}>
        {t.addTask}
      </button>
    );
  return (
    <form className={isFirst ? "new-task is-first" : "new-task"} onSubmit={make} onKeyDown={(event) => event.key === "Escape" && setAsks(false)}>
      {isFirst && (
        <>
          <h3>{t.firstTask}</h3>
          <p>{t.aboutTasks}</p>
        </>
      )}
      <div>
        <input aria-label={t.taskName} placeholder={t.taskHint} maxLength={40} autoFocus={asks === true} value={title} onChange={(event) => setTitle(event.target.value)} />
        <button type="submit" className="main">
          {t.makeTask}
        </button>
        {!isFirst && (
          <button type="button" onClick={() => setAsks(false)}>
            {t.cancel}
          </button>
        )}
      </div>
    </form>
  );
}

/** What is dragged, at the pointer. */
function DragGhost() {
  const drag = useDragged((now) => now);
  if (drag === undefined) return null;
  return (
    <div className={`ghost${drag.over === undefined ? " is-nowhere" : ""}`} style={{ translate: `min(${drag.x + 14}px, 100vw - 190px) ${drag.y + 10}px` }}>
      {drag.what.title}
    </div>
  );
}
