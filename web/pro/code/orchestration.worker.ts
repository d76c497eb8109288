// Finds the operations that no service can accept somewhere, beside the page: for a task of 2000 states that takes some hundred milliseconds.
import type { Spot, Task } from "../../shared/code/assistance";
import { unreachableOperations } from "../../shared/orchestration/unreachable";

export interface Question {
  readonly number: number;
  /** Nothing: the one of the question before. */
  readonly task?: Task;
  /** Nothing: the task is only made ready. */
  readonly spot?: Spot;
}

export interface Answer {
  readonly number: number;
  readonly unreachable: ReadonlyMap<string, string>;
}

let task: Task | undefined;

addEventListener("message", ({ data }: MessageEvent<Question>) => {
  task = data.task ?? task;
  const { path, place } = data.spot ?? { path: "", place: { code: "action" } as const };
  const unreachable = task === undefined ? new Map<string, string>() : unreachableOperations(task.document, task.services, path, place);
  postMessage({ number: data.number, unreachable } satisfies Answer);
});
