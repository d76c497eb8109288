import { describe, expect, test } from "vitest";
import { contrast, over, palette, rgbaOf, type Palette, type Rgba } from "./contrast";
import { graphicsPairs, textPairs } from "./pairs";
import { declarations, sources, tokensSheet } from "./sources";

const sheets = sources(/\.css$/);
const tokens = declarations(sheets.find(({ name }) => name === tokensSheet)?.text ?? "");
const kThemes = ["light", "dark"] as const;

function colour(colours: Palette, token: string): Rgba {
  const found = colours.get(token);
  if (found === undefined) throw new Error(`tokens.css has no colour --${token}`);
  return found;
}

/** The pairs that have less contrast than `least`; a surface that lets through lies on the paper. */
function tooPale(colours: Palette, pairs: Readonly<Record<string, readonly string[]>>, least: number): readonly string[] {
  const paper = colour(colours, "paper");
  return Object.entries(pairs).flatMap(([surface, marks]) =>
    marks.flatMap((mark) => {
      const below = over(colour(colours, surface), paper);
      const ratio = contrast(over(colour(colours, mark), below), below);
      return ratio < least ? [`--${mark} on --${surface}: ${ratio.toFixed(2)}`] : [];
    }),
  );
}

describe("contrast", () => {
  test("of black and white is 21, of a colour and itself 1", () => {
    expect(contrast(rgbaOf("#000000"), rgbaOf("#ffffff"))).toBeCloseTo(21);
    expect(contrast(rgbaOf("#2b6b8a"), rgbaOf("#2b6b8a"))).toBe(1);
  });

  test("of #767676 and white is 4.54, as WCAG gives it", () => {
    expect(contrast(rgbaOf("#767676"), rgbaOf("#ffffff"))).toBeCloseTo(4.54, 2);
  });

  test("pale text is found", () => {
    const colours = palette([{ selector: ":root", property: "--paper", value: "#ffffff" }, { selector: ":root", property: "--ink", value: "#aaaaaa" }], "light");
    expect(tooPale(colours, { paper: ["ink"] }, 4.5)).toEqual(["--ink on --paper: 2.32"]);
  });

  test.each(kThemes)("of text is at least 4.5 in the %s theme", (theme) => {
    expect(tooPale(palette(tokens, theme), textPairs, 4.5)).toEqual([]);
  });

  test.each(kThemes)("of graphics is at least 3 in the %s theme", (theme) => {
    expect(tooPale(palette(tokens, theme), graphicsPairs, 3)).toEqual([]);
  });

  test("every rule that sets a text colour and a surface uses a pair of the table", () => {
    const token = (value: string | undefined) => /^var\(--([\w-]+)\)/.exec(value ?? "")?.[1];
    const unknown = sheets.flatMap(({ name, text }) =>
      [...text.matchAll(/[^{}]+\{[^{}]*\}/g)].flatMap(([rule]) => {
        const all = declarations(rule);
        const value = (...properties: readonly string[]) => token(all.find(({ property }) => properties.includes(property))?.value);
        const [mark, surface] = [value("color"), value("background", "background-color")];
        return mark === undefined || surface === undefined || mark === "disabled" || textPairs[surface]?.includes(mark) === true ? [] : [`${name}: --${mark} on --${surface}`];
      }),
    );
    expect(unknown).toEqual([]);
  });
});
