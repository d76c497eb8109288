// Which colours lie on which surfaces of the expert page, by their tokens.

const kWords = ["ink", "soft", "faint", "accent", "active-ink", "wait-ink", "bad"] as const;
const kRules = ["rule-down", "refinement"] as const;
const kProgram = ["code-keyword", "code-call", "code-string", "code-number", "code-comment"] as const;

/** Text on each surface: at least 4.5:1. */
export const textPairs: Readonly<Record<string, readonly string[]>> = {
  paper: kWords,
  panel: [...kWords, ...kRules, ...kProgram, "brand", "oracle", "hand-ink"],
  sunken: [...kWords, ...kRules],
  inset: [...kWords, ...kProgram, "oracle"],
  floating: [...kWords, "hand-ink"],
  "accent-soft": ["ink", "soft", "faint", "accent", "active-ink", ...kRules],
  "active-soft": ["ink", "soft", "faint", "accent", "active-ink"],
  "active-hover": ["active-ink", "soft"],
  "wait-soft": ["ink", "soft", "wait-ink"],
  "wait-hover": ["wait-ink"],
  "bad-soft": ["ink", "soft", "bad"],
  "oracle-soft": ["ink", "oracle"],
  brand: ["on-fill"],
  "brand-hover": ["on-fill"],
  accent: ["on-fill"],
  bad: ["on-fill"],
  hand: ["on-fill"],
  fired: ["on-fired"],
  "fired-flash": ["on-fired"],
};

/** Lines, borders that carry a meaning, signs and dots on each surface: at least 3:1. */
export const graphicsPairs: Readonly<Record<string, readonly string[]>> = {
  paper: ["outline", "line", "line-quiet", "solid", "active", "fired-line", "accent", "wait", "bad", "oracle", "breakpoint"],
  panel: ["outline", "line", "line-quiet", "solid", "active", "fired-line", "accent", "wait", "bad", "brand", "oracle", "breakpoint"],
  inset: ["outline", "line", "line-quiet", "solid", "active", "fired-line", "accent", "wait", "bad", "breakpoint"],
  sunken: ["accent", "active", "wait", "bad", "breakpoint"],
  "accent-soft": ["accent", "active", "breakpoint"],
  "active-soft": ["active", "accent", "solid", "line", "fired-line"],
  "wait-soft": ["wait"],
  "bad-soft": ["bad"],
  fired: ["on-fired"],
  "cell-background": ["hand"],
};
