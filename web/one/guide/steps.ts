// The ways between the steps of the guide.
import { go, kGuideSteps, type GuideStep } from "../place";

export const stepAt = (step: GuideStep, by: -1 | 1): GuideStep | undefined => kGuideSteps[kGuideSteps.indexOf(step) + by];

/** Steps that show an application, which stays open between them. */
const kOfApplication: readonly GuideStep[] = ["application", "run"];

/** Another step; the run of the calibration is left with its step. */
export function goToStep(step: GuideStep, from: GuideStep): void {
  go({ guide: step, view: "build", task: undefined, step: undefined, ...(from === "camera" && { edit: undefined }), ...(!kOfApplication.includes(step) && { edit: undefined }) });
}

export const leaveGuide = (): void => go({ guide: undefined, part: undefined, goal: undefined, edit: undefined, task: undefined, step: undefined, view: "build" });
