import { describe, expect, it } from "vitest";
import type { Samples } from "../../generated/messages";
import { poseAt } from "../../shared/past/samples";

const samples: Samples = [[1, 0.2], [1, 0.4], [3, 0.6], [3, 0.8]].map(([step = 0, time = 0]) => ({ step, pose: { time, joints: {}, bodies: {} } }));
const time = (step: number) => poseAt(samples, step)?.time;

describe("the cell at a macro step", () => {
  it("is as it was first sampled after that had begun", () => expect([time(1), time(2), time(3)]).toEqual([0.2, 0.6, 0.6]));
  it("is as it was last, after the last sample", () => expect(time(9)).toBe(0.8));
  it("is not known without samples", () => expect(poseAt([], 1)).toBeUndefined());
});
