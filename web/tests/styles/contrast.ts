// Contrast of two colours as WCAG 2.2 defines it, and the tokens of a theme as colours.
import type { Declaration } from "./sources";

/** Red, green, blue of 0..255, and opacity. */
export type Rgba = readonly [number, number, number, number];
export type Palette = ReadonlyMap<string, Rgba>;

/** A colour as tokens.css writes it: `#rrggbb` or `#rrggbbaa`. */
export function rgbaOf(hex: string): Rgba {
  if (!/^#(?:[0-9a-f]{6}|[0-9a-f]{8})$/.test(hex)) throw new Error(`${hex} is not #rrggbb or #rrggbbaa`);
  const byte = (at: number) => parseInt(hex.slice(at, at + 2), 16);
  return [byte(1), byte(3), byte(5), hex.length === 9 ? byte(7) / 255 : 1];
}

/** `above` as it looks on `below`, which is opaque. */
export function over(above: Rgba, below: Rgba): Rgba {
  const mix = (i: 0 | 1 | 2) => above[i] * above[3] + below[i] * (1 - above[3]);
  return [mix(0), mix(1), mix(2), 1];
}

function luminance([red, green, blue]: Rgba): number {
  const linear = (byte: number) => (byte / 255 <= 0.04045 ? byte / 255 / 12.92 : ((byte / 255 + 0.055) / 1.055) ** 2.4);
  return 0.2126 * linear(red) + 0.7152 * linear(green) + 0.0722 * linear(blue);
}

/** The contrast ratio of two opaque colours, 1..21. */
export function contrast(a: Rgba, b: Rgba): number {
  const [light, dark] = [luminance(a), luminance(b)].sort((x, y) => y - x);
  return ((light ?? 0) + 0.05) / ((dark ?? 0) + 0.05);
}

/** The colour tokens of a theme by name, without `--`. */
export function palette(tokens: readonly Declaration[], theme: "light" | "dark"): Palette {
  return new Map(
    tokens.flatMap(({ property, value }) => {
      const both = /^light-dark\((#\w+), (#\w+)\)$/.exec(value);
      const hex = both?.[theme === "light" ? 1 : 2] ?? (/^#\w+$/.test(value) ? value : undefined);
      return property.startsWith("--") && hex !== undefined ? [[property.slice(2), rgbaOf(hex)] as const] : [];
    }),
  );
}
