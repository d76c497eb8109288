// What an atom of a condition waits for, of what it reads of services: a response that has come and is held by a pause, or a call that is not answered.
import type { Past, WhyAtom } from "../../generated/messages";
import { calledText, type OpenCall } from "./openCalls";

/** `robot.move` of `svc.robot.move.result.pose`, `robot.collision` of `svc.robot.collision`. */
function subjectOf(text: string): { readonly service: string; readonly name: string } | undefined {
  const [, service, name] = /^svc\.(\w+)\.(\w+)/.exec(text) ?? [];
  return service === undefined || name === undefined ? undefined : { service, name };
}

function heldText({ service, name }: { readonly service: string; readonly name: string }, held: Past["waiting"]): string | undefined {
  const at = held?.inputs.findIndex(({ input }) => (input.kind === "response" && input.service === service && input.operation === name) || (input.kind === "event" && input.service === service && input.event === name)) ?? -1;
  const kind = held?.inputs[at]?.input.kind;
  if (kind === undefined) return undefined;
  return `${service}.${name}: its ${kind} is queued; ${at === 0 ? "a step delivers it" : `${at + 1} steps deliver it`}`;
}

/** `held`: what has come to a run that is paused; `now`: the time of the cell. */
export function awaitedTexts({ requires = [] }: Pick<WhyAtom, "requires">, held: Past["waiting"], calls: readonly OpenCall[], now: number | undefined): readonly string[] {
  const texts = requires.flatMap((text) => {
    const subject = subjectOf(text);
    if (subject === undefined) return [];
    const queued = heldText(subject, held);
    if (queued !== undefined) return [queued];
    const open = calls.filter(({ service, operation }) => service === subject.service && operation === subject.name).at(-1);
    return open === undefined ? [] : [`${subject.service}.${subject.name} ${calledText(open, now)}`];
  });
  return [...new Set(texts)];
}
