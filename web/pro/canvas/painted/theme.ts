// The colours and fonts of the page for what is painted: the custom properties of styles/tokens.css, as they are in the present theme.
import { listenToTheme as listenToPage } from "../../theme/theme";
import { tokenColours } from "../../theme/tokenColour";

const kColours = [
  "paper", "panel", "inset", "ink", "soft", "faint", "edge", "edge-strong", "outline", "line", "line-quiet", "solid", "accent", "accent-soft",
  "active", "active-ink", "active-soft", "active-edge", "active-glow", "fired", "on-fired", "fired-line", "fired-flash", "wait", "wait-soft", "wait-ink",
  "bad", "bad-soft", "on-fill", "oracle", "oracle-soft", "canvas-dots", "minimap-node", "minimap-outer", "minimap-mask",
] as const;

export type Colour = (typeof kColours)[number];

export interface Theme {
  readonly colours: Readonly<Record<Colour, string>>;
  readonly sans: string;
  readonly mono: string;
}

export function readTheme(): Theme {
  const found = tokenColours(kColours.map((name) => `--${name}` as const));
  const style = getComputedStyle(document.documentElement);
  const colours = Object.fromEntries(kColours.map((name, i) => [name, found[i] ?? ""])) as Record<Colour, string>;
  return { colours, sans: style.getPropertyValue("--sans"), mono: style.getPropertyValue("--mono") };
}

/** Calls `changed` when the theme of the page changes or its fonts have come; the result ends that. */
export function listenToTheme(changed: () => void): () => void {
  const end = listenToPage(changed);
  document.fonts.addEventListener("loadingdone", changed);
  return () => {
    end();
    document.fonts.removeEventListener("loadingdone", changed);
  };
}
