// What a page that gives one answer does upon each question that its display shows.

/** `send`: the question is there that was seen; `given`: it has been answered; `gone`: it is not asked any more; `wait`: nothing yet. */
export type Giving = "send" | "given" | "gone" | "wait";

/** `asked`: the question that is shown now; `wanted`: the text of the one that was seen; `sent`: the id of the question that the answer has been
 *  sent to. A task may ask the same again at once: that is another question, of another id. */
export function giving(asked: { readonly id: number; readonly text: string } | undefined, wanted: string | undefined, sent: number | undefined): Giving {
  if (sent !== undefined) return asked?.id === sent ? "wait" : "given";
  return asked !== undefined && asked.text === wanted ? "send" : "gone";
}
