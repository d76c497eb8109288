// The colours and fonts of the page for what is painted: the custom properties of styles/tokens.css, as they are in the present theme.
import { listenToTheme as listenToPage } from "../../theme/theme";

const kColours = [
  "paper", "panel", "inset", "ink", "soft", "faint", "edge", "edge-strong", "outline", "line", "line-quiet", "solid", "accent", "accent-soft",
  "active", "active-ink", "active-soft", "active-edge", "active-glow", "fired", "on-fired", "fired-line", "fired-flash", "wait", "wait-soft", "wait-ink",
  "bad", "bad-soft", "oracle", "oracle-soft", "canvas-dots", "minimap-node", "minimap-outer", "minimap-mask",
] as const;

export type Colour = (typeof kColours)[number];

export interface Theme {
  readonly colours: Readonly<Record<Colour, string>>;
  readonly sans: string;
  readonly mono: string;
}

/** The theme as it is where `element` is. */
export function readTheme(element: HTMLElement): Theme {
  const probe = element.appendChild(document.createElement("i"));
  const style = getComputedStyle(probe);
  const colours = Object.fromEntries(
    kColours.map((name) => {
      probe.style.color = `var(--${name})`;
      return [name, style.color];
    }),
  ) as Record<Colour, string>;
  const theme = { colours, sans: style.getPropertyValue("--sans"), mono: style.getPropertyValue("--mono") };
  probe.remove();
  return theme;
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
