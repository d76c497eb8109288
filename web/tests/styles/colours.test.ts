import { describe, expect, test } from "vitest";
import { literalsOfCode, literalsOfValue } from "./literals";
import { declarations, sources, tokensSheet } from "./sources";

const sheets = sources(/\.css$/);
const code = sources(/\.(?:tsx?|html)$/);

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

  test.each(sheets.filter(({ name }) => name !== tokensSheet))("$name has none", ({ text }) => {
    expect(declarations(text).flatMap(({ selector, property, value }) => literalsOfValue(value).map((literal) => `${selector} { ${property}: ${literal} }`))).toEqual([]);
  });

  test("the code of the page has none", () => {
    expect(code.flatMap(({ name, text }) => literalsOfCode(text).map((literal) => `${name}: ${literal}`))).toEqual([]);
  });

  test("in tokens.css only tokens have one", () => {
    const sheet = sheets.find(({ name }) => name === tokensSheet)?.text ?? "";
    expect(declarations(sheet).filter(({ property, value }) => !property.startsWith("--") && literalsOfValue(value).length > 0)).toEqual([]);
  });
});

describe("tokens", () => {
  const texts = [...sheets, ...code];
  const used = new Set(texts.flatMap(({ text }) => [...text.matchAll(/var\((--[\w-]+)|["'](--[\w-]+)["']/g)].map(([, css, string]) => css ?? string ?? "")));

  test("every name that is used is a token, or set where it is used", () => {
    const set = new Set(texts.flatMap(({ text }) => [...text.matchAll(/(?<!\()(--[\w-]+)["']?\]?\s*[:,]/g)].map(([, name]) => name ?? "")));
    expect([...used].filter((name) => !set.has(name))).toEqual([]);
  });
});
