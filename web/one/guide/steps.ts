// The ways between the steps of the guide.
import { go, kGuideSteps, type GuideStep } from "../place";

export const stepAt = (step: GuideStep, by: -1 | 1): GuideStep | undefined => kGuideSteps[kGuideSteps.indexOf(step) + by];

/** Another step. What is open stays so, but the step of the camera opens an application of its own. */
export function goToStep(step: GuideStep, from: GuideStep): void {
  go({ guide: step, view: "build", task: undefined, step: undefined, ...((from === "camera" || step === "camera") && { edit: undefined }) });
}

export const leaveGuide = (): void => go({ guide: undefined, part: undefined, goal: undefined, edit: undefined, task: undefined, step: undefined, view: "build" });
