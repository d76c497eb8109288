// What the answers of a person to a question about a failure are called: the ports of what asks have titles, where its model gives some.
import { entryOf } from "../json";
import type { Tree } from "../edit/tree";
import { declaredIn, textOf } from "../skills/declared";
import type { TimeLine } from "./timeLine";
import { allSteps } from "./timeLine";

/** `chi.Ask.res.answer == 'Skip'`: the answer with which a port fires. */
const kAnswer = /\banswer\s*==\s*(?:'([^']*)'|"([^"]*)")/g;

/** The titles of answers, by what is answered; of a state that asks, such as `WhatNow` or a link to it. */
export function answerTitles(tree: Tree, asking: string): ReadonlyMap<string, string> {
  return new Map(
    declaredIn(tree, asking, "ports").flatMap(({ fields, meta }) => {
      const title = textOf(entryOf(meta, "title"));
      const answers = [...(textOf(entryOf(fields, "when")) ?? "").matchAll(kAnswer)].map(([, single, double]) => single ?? double ?? "");
      return title === undefined ? [] : answers.map((answer) => [answer, title] as const);
    }),
  );
}

/** The same of what asks about a failure now; none, if nothing does. `active`: ids of states. */
export function titlesAsked(tree: Tree, root: TimeLine, active: ReadonlySet<string>): ReadonlyMap<string, string> {
  const asking = allSteps(root).flatMap(({ handlers }) => handlers).find((id) => active.has(id) && tree.elements.has(id));
  return asking === undefined ? new Map() : answerTitles(tree, asking);
}

/** How the buttons of a question are called, in their order: by titles that tell them apart, or as they are. */
export function buttonTitles(buttons: readonly string[], titles: ReadonlyMap<string, string>): readonly string[] {
  const named = buttons.map((button) => titles.get(button) ?? button);
  return new Set(named).size === buttons.length ? named : buttons;
}
