import { describe, expect, test } from "vitest";
import { contrast, over, palette, rgbaOf, type Palette, type Rgba } from "./contrast";
import { graphicsPairs, textPairs, type Pairs } from "./pairs";
import { declarations, sheetsOf } from "./sources";

const kPages = ["pro", "one", "cell", "display", "stop", "control", "trust"] as const;
const kViews = kPages.flatMap((page) => (["light", "dark"] as const).map((theme) => ({ page, theme })));

function colour(colours: Palette, token: string): Rgba {
  const found = colours.get(token);
  if (found === undefined) throw new Error(`tokens.css has no colour --${token}`);
  return found;
}

/** The pairs that have less contrast than `least`; a surface that lets through lies on the paper. */
function tooPale(colours: Palette, pairs: Pairs, least: number): readonly string[] {
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

  test.each(kViews)("of text is at least 4.5 in $page, $theme", ({ page, theme }) => {
    expect(tooPale(palette(sheetsOf(page).tokens, theme), textPairs[page], 4.5)).toEqual([]);
  });

  test.each(kViews)("of graphics is at least 3 in $page, $theme", ({ page, theme }) => {
    expect(tooPale(palette(sheetsOf(page).tokens, theme), graphicsPairs[page], 3)).toEqual([]);
  });

  test.each(kPages)("is known of every rule of %s that sets a text colour and a surface", (page) => {
    const token = (value: string | undefined) => /^var\(--([\w-]+)\)/.exec(value ?? "")?.[1];
    const unknown = sheetsOf(page).others.flatMap(({ name, text }) =>
      [...text.matchAll(/[^{}]+\{[^{}]*\}/g)].flatMap(([rule]) => {
        const all = declarations(rule);
        const value = (...properties: readonly string[]) => token(all.find(({ property }) => properties.includes(property))?.value);
        const [mark, surface] = [value("color"), value("background", "background-color")];
        const known = mark === undefined || surface === undefined || mark === "disabled" || textPairs[page][surface]?.includes(mark) === true;
        return known ? [] : [`${name}: --${mark} on --${surface}`];
      }),
    );
    expect(unknown).toEqual([]);
  });
});
