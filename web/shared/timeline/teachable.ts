// Whether a step has failed for its place, so that to teach its poses again may help.
import type { JsonValue } from "../json";
import { isPoseName } from "../pendant/poses";
import type { Failed } from "./progress";

/** Errors of skills that the place may be the reason of: nobody has taught it, the arm does not get there, or what is to be there is not. */
const kOfPlace: ReadonlySet<string> = new Set(["no_pose", "unreachable", "no_part", "collision", "blocked"]);

/** The taught poses of a step that has failed so. `parameters`: what the run has given to it, as far as that is known. */
export function posesToTeach({ step, port }: Pick<Failed, "step" | "port">, parameters: Readonly<Record<string, JsonValue>> = {}): readonly string[] {
  if (!kOfPlace.has(port)) return [];
  const names = step.parameters.flatMap(({ about, value }) => {
    if (about.domain !== "pose") return [];
    const name = parameters[about.name] ?? (value.kind === "constant" ? value.value : undefined);
    return typeof name === "string" && isPoseName(name) ? [name] : [];
  });
  return [...new Set(names)];
}

/** Of a title, `WhatNow` says as much as this at least. */
const kSaid = 50;

/** Whether a question is that of `WhatNow` (api/skills.md) about a step: what is to be done, as it has failed. */
export function asksAbout(question: { readonly text: string; readonly buttons?: readonly string[] }, title: string): boolean {
  const [said = ""] = question.text.split(" has failed");
  const isOfStep = said !== question.text && (said === title || (said.length >= kSaid && title.startsWith(said)));
  return isOfStep && ["Retry", "Skip", "Abort"].every((answer) => question.buttons?.includes(answer) === true);
}
export const kRetry = "Retry";
