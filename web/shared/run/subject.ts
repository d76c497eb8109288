// What an explanation is about: a port, an action or a parameter.

export type Subject =
  /** By its address, `Root/Pick/Grasp.success`. */
  | { readonly port: string }
  /** By the number within its state, from 0. */
  | { readonly state: string; readonly action: number }
  | { readonly state: string; readonly parameter: string };

/** What is asked about of the state that is selected. */
export type Asked = { readonly action: number } | { readonly parameter: string };

export const isSameAsked = (a: Asked | undefined, b: Asked | undefined): boolean => askedText(a) === askedText(b);

/** As the address of the page has it: `action.0`, `par.width`. */
export const askedText = (asked: Asked | undefined): string | undefined => asked && ("action" in asked ? `action.${asked.action}` : `par.${asked.parameter}`);

export function askedOf(text: string | undefined): Asked | undefined {
  const [, number, parameter] = /^(?:action\.(\d{1,6})|par\.([^\s/.]{1,200}))$/u.exec(text ?? "") ?? [];
  if (number !== undefined) return { action: Number(number) };
  return parameter === undefined ? undefined : { parameter };
}

/** The query by which the server is asked. */
export function subjectQuery(subject: Subject): string {
  if ("port" in subject) return `port=${encodeURIComponent(subject.port)}`;
  const state = `state=${encodeURIComponent(subject.state)}`;
  return "action" in subject ? `${state}&action=${subject.action}` : `${state}&parameter=${encodeURIComponent(subject.parameter)}`;
}
