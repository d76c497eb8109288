// Where everything in the cell was at a macro step of a run, by the samples that are stored with it.
import type { Samples } from "../../generated/messages";

/** The pose in macro step `step`: the first one that was sampled after it had begun, else the last of the run; nothing without any. */
export const poseAt = (samples: Samples, step: number): Samples[number]["pose"] | undefined => (samples.find((sample) => sample.step >= step) ?? samples.at(-1))?.pose;
