// What runs came to, in numbers.
import { expect, it } from "vitest";
import { outcomesOf } from "../../shared/runs/outcomes";

const ended = (outcome: string, time: number) => ({ status: "ended", outcome, created: 1000, ended: 1000 + time }) as const;

it("counts those that are over, by what they came to, and what those took that have finished", () => {
  const runs = [{ status: "running", created: 1 }, ended("error", 5), ended("success", 300), { status: "aborted", created: 1, ended: 2 }, { status: "faulted", created: 1, ended: 2 }, ended("done", 100)] as const;
  expect(outcomesOf(runs)).toEqual({ over: 5, finished: 2, failed: 2, stopped: 1, last: 300, mean: 200 });
});

it("knows no time where nothing has finished", () => {
  expect(outcomesOf([ended("error", 5)])).toEqual({ over: 1, finished: 0, failed: 1, stopped: 0, last: undefined, mean: undefined });
});
