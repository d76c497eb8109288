import { describe, expect, test } from "vitest";
import { literalsOfCode, literalsOfValue } from "./literals";
import { declarations, sheetsOf, sources } from "./sources";

const kPages = ["pro", "one", "cell", "display", "stop", "control", "trust"] as const;

describe("literal colours", () => {
  test.each(["#fff", "1px solid #c2ccc7", "rgb(255 255 255 / 90%)", "0 1px 2px hsl(20 10% 10%)", "white", "2px dashed Red"])("`%s` is found in a style sheet", (value) => {
    expect(literalsOfValue(value)).not.toEqual([]);
  });

  test.each(["var(--white)", "1px solid var(--edge)", "transparent", "currentColor", "url(#red-arrow)", "inherit", "color-mix(in srgb, var(--bad) 40%, transparent)"])(
    "`%s` is none",
    (value) => {
      expect(literalsOfValue(value)).toEqual([]);
    },
  );

  test.each(['fill="#94e480"', "new Color(0xf0f2ef)", 'style={{ background: "white" }}', 'context.fillStyle = "rgb(0 0 0)"', 'stroke={"red"}'])("`%s` is found in code", (text) => {
    expect(literalsOfCode(text)).not.toEqual([]);
  });

  test.each(['fill="none"', 'fill="var(--fired)"', 'href="#search"', 'name="red"', "0xff", 'querySelector("#add-state")'])("`%s` is none in code", (text) => {
    expect(literalsOfCode(text)).toEqual([]);
  });

  test.each(kPages)("are in no style sheet of %s but tokens.css, and there only as tokens", (page) => {
    const { tokens, others } = sheetsOf(page);
    const literals = [...others.flatMap(({ text }) => declarations(text)), ...tokens.filter(({ property }) => !property.startsWith("--"))].flatMap(
      ({ selector, property, value }) => literalsOfValue(value).map((literal) => `${selector} { ${property}: ${literal} }`),
    );
    expect(literals).toEqual([]);
  });

  test.each(kPages)("are not in the code of %s", (page) => {
    expect(sources(page, /\.tsx?$/).flatMap(({ name, text }) => literalsOfCode(text).map((literal) => `${name}: ${literal}`))).toEqual([]);
  });
});

describe("custom properties", () => {
  test.each(kPages)("that %s uses are tokens, or set by its code", (page) => {
    const texts = sources(page, /\.(?:css|tsx?)$/).map(({ text }) => text);
    const names = (pattern: RegExp) => new Set(texts.flatMap((text) => [...text.matchAll(pattern)].map(([, name]) => name ?? "")));
    const used = names(/(?:var|tokenColour)\(["']?(--[\w-]+)/g);
    const set = new Set([...names(/(?<!\()(--[\w-]+)["']?\]?\s*[:,]/g), ...sheetsOf(page).tokens.map(({ property }) => property)]);
    expect(used.size).toBeGreaterThan(0);
    expect([...used].filter((name) => !set.has(name))).toEqual([]);
  });
});
