// The tasks of an application with their time lines.
import { useState, type SubmitEvent } from "react";
import { addTask } from "../../shared/timeline/changes/add";
import type { Application } from "../../shared/timeline/read";
import { perform, useEditing } from "../editing";
import { useProblems } from "../model";
import { go } from "../place";
import { select } from "../select";
import { showSheet } from "../sheet";
import { useDragged } from "./drag";
import { TaskCard } from "./TaskCard";

export function Tasks({ application }: { readonly application: Application }) {
  const problems = useProblems();
  const { tasks, isEditable, root } = application;
  const errors = useEditing((now) => now.session?.errors.length ?? 0);
  return (
    <main className="tasks" aria-label="Tasks">
      <div className="tasks-head">
        <h2>Tasks</h2>
        <ReadyText problems={problems.length} errors={errors} first={problems[0]?.step} isEmpty={tasks.length === 0} />
      </div>
      {!isEditable && (
        <p className="notice">
          This application does more than tasks show: {root.reason}. Here you can look at it, set its values and run it.
        </p>
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
        {problems === 1 ? "1 thing is missing: show it" : `${problems} things are missing: show the first`}
      </button>
    );
  if (errors > 0) return <p className="todo is-text">It has errors, which RACE Pro shows.</p>;
  return (
    <button type="button" className="main" onClick={() => go({ view: "run" })}>
      Ready: go to Run
    </button>
  );
}

function NewTask({ isFirst, at, root }: { readonly isFirst: boolean; readonly at: number; readonly root: string }) {
  const [asks, setAsks] = useState(false);
  const [title, setTitle] = useState("");
  const make = (event: SubmitEvent) => {
    event.preventDefault();
    const id = perform((tree, supplies) => addTask(tree, root, at, title.trim() === "" ? `Task ${at + 1}` : title, supplies));
    if (id === undefined) return;
    select(id, false);
    setAsks(false);
    setTitle("");
    showSheet("library");
  };
  if (!isFirst && !asks)
    return (
      <button type="button" className="add-task" onClick={() => setAsks(true)}>
        + Add a task
      </button>
    );
  return (
    <form className={isFirst ? "new-task is-first" : "new-task"} onSubmit={make}>
      {isFirst && (
        <>
          <h3>Begin with a task</h3>
          <p>A task is a row of skills that are done one after the other: move there, pick, place. What is it to be called?</p>
        </>
      )}
      <div>
        <input aria-label="Name of the task" placeholder="Name, such as: pick parts" maxLength={40} autoFocus={asks} value={title} onChange={(event) => setTitle(event.target.value)} />
        <button type="submit" className="main">
          Add the task
        </button>
        {!isFirst && (
          <button type="button" onClick={() => setAsks(false)}>
            Cancel
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
