// Which colours lie on which surfaces of the pages, by their tokens.
import type { PageName } from "./sources";

/** The colours on each surface. */
export type Pairs = Readonly<Record<string, readonly string[]>>;

const kWords = ["ink", "soft", "faint", "accent", "active-ink", "wait-ink", "bad"] as const;
const kRules = ["rule-down", "refinement"] as const;
const kProgram = ["code-keyword", "code-call", "code-string", "code-number", "code-comment"] as const;

const kPeople = ["person-0", "person-1", "person-2", "person-3", "person-4", "person-5", "person-6", "person-7"] as const;

const kProText: Pairs = {
  ...Object.fromEntries(kPeople.map((person) => [person, ["on-fill"]])),
  paper: kWords,
  panel: [...kWords, ...kRules, ...kProgram, "brand", "oracle", "hand-ink", "uncovered"],
  sunken: [...kWords, ...kRules],
  inset: [...kWords, ...kProgram, "oracle"],
  floating: [...kWords, "hand-ink"],
  "accent-soft": ["ink", "soft", "faint", "accent", "active-ink", ...kRules],
  "active-soft": ["ink", "soft", "faint", "accent", "active-ink"],
  "active-inset": ["ink", "active-ink"],
  "active-hover": ["active-ink", "soft"],
  "wait-soft": ["ink", "soft", "wait-ink", "bad"],
  "wait-hover": ["wait-ink"],
  "bad-soft": ["ink", "soft", "bad", "accent"],
  "oracle-soft": ["ink", "oracle"],
  brand: ["on-fill"],
  "brand-hover": ["on-fill"],
  accent: ["on-fill"],
  bad: ["on-fill"],
  hand: ["on-fill"],
  fired: ["on-fired"],
  uncovered: ["on-fill"],
};

const kProGraphics: Pairs = {
  paper: ["outline", "line", "line-quiet", "solid", "active", "fired-line", "accent", "wait", "bad", "breakpoint", "uncovered", "oracle", ...kPeople],
  panel: ["outline", "line", "line-quiet", "solid", "active", "fired-line", "accent", "wait", "bad", "breakpoint", "uncovered", "brand", "oracle", ...kPeople],
  inset: ["outline", "line", "line-quiet", "solid", "active", "fired-line", "accent", "wait", "bad", "breakpoint", "uncovered", ...kPeople],
  sunken: ["accent", "active", "wait", "bad", "breakpoint"],
  "accent-soft": ["accent", "active"],
  "active-inset": ["outline", "line", "line-quiet", "solid", "active", "fired-line", "accent"],
  "active-soft": ["active", "accent", "solid", "line", "fired-line"],
  "wait-soft": ["wait", "breakpoint"],
  "bad-soft": ["bad"],
  fired: ["on-fired"],
  "cell-background": ["hand"],
};

const kDisplayText: Pairs = {
  paper: ["ink", "soft", "bad", "open"],
  panel: ["ink", "soft", "bad"],
  "note-soft": ["ink"],
  "bad-soft": ["bad"],
  bad: ["bad-soft"],
  choice: ["choice-ink"],
};

const kStopText: Pairs = { stop: ["on-stop"], "stop-pressed": ["on-stop"], panel: ["ink"] };

const kControlText: Pairs = { panel: ["ink", "soft"], paper: ["ink"], ink: ["panel"], "bad-soft": ["bad"] };

/** Text: at least 4.5:1. */
export const textPairs: Readonly<Record<PageName, Pairs>> = { pro: kProText, one: kProText, cell: kProText, display: kDisplayText, stop: kStopText, control: kControlText, trust: kDisplayText };

const kDisplayGraphics: Pairs = { paper: ["soft", "choice"], panel: ["soft"] };

/** Lines, borders that carry a meaning, signs, dots and the focus: at least 3:1. */
export const graphicsPairs: Readonly<Record<PageName, Pairs>> = { pro: kProGraphics, one: kProGraphics, cell: kProGraphics, display: kDisplayGraphics, stop: { stop: ["on-stop"], panel: ["soft"] }, control: { panel: ["soft", "ink"], ink: ["panel"] }, trust: kDisplayGraphics };
