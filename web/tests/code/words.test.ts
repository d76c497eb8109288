// The words of the pages are those of core/language, which is read as text: neither has a word or parameter that the other has not.
import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { describe, expect, it } from "vitest";
import { kDictMethods, kListMethods, kTextMethods } from "../../shared/code/methods";
import { kBuiltins, kExpressionKeywords, kKeywords, kModules, kStatementKeywords, parametersText, type LanguageFunction } from "../../shared/code/words";

const source = (path: string): string => readFileSync(fileURLToPath(new URL(`../../../core/language/${path}`, import.meta.url)), "utf8");

/** The rows of a table of functions.cpp. */
function rows(name: string): readonly (readonly string[])[] {
  const [, table = ""] = new RegExp(`${name} = \\{(.*?)\\n\\};`, "s").exec(source("library/functions.cpp")) ?? [];
  return [...table.matchAll(/Function\{"(\w+)", "([^"]*)"/g)].map(([, function_ = "", parameters = ""]) => [function_, parameters]);
}

const written = (functions: readonly LanguageFunction[] | undefined) => functions?.map(({ name, parameters }) => [name, parameters]);

describe("the words of the language", () => {
  it("are its functions with their parameters", () => {
    expect(written(kBuiltins)).toEqual(rows("kBuiltins"));
    expect(written(kModules["math"]?.functions)).toEqual(rows("kMath"));
    expect(written(kModules["geo"]?.functions)).toEqual(rows("kGeo"));
  });

  it("are its methods with their parameters", () => {
    const [, table = ""] = /kMethods = \{(.*?)\n\};/s.exec(source("library/functions.cpp")) ?? [];
    const texts = [...table.matchAll(/text\("(\w+)", "([^"]*)"/g)].map(([, name = "", parameters = ""]) => [name, parameters] as const);
    const others = [...table.matchAll(/Method\{"(\w+)", (.*?)\}/g)].map(([, name = "", overloads = ""]) => [name, [...overloads.matchAll(/kNo|\w+\("([^"]*)"/g)].map(([, parameters]) => parameters)] as const);
    const of = (i: number) => others.flatMap(([name, overloads]) => (overloads[i] === undefined ? [] : [[name, overloads[i]] as const]));
    expect(kTextMethods).toEqual(Object.fromEntries([...texts, ...of(0)]));
    expect(kListMethods).toEqual(Object.fromEntries(of(1)));
    expect(kDictMethods).toEqual(Object.fromEntries(of(2)));
  });

  it("are its constants", () => {
    const [, table = ""] = /kConstants.*?\{(\{.*?)\}\}\};/s.exec(source("library/functions.cpp")) ?? [];
    expect(kModules["math"]?.constants).toEqual([...table.matchAll(/\{"(\w+)", Value/g)].map(([, name]) => name));
  });

  it("are its keywords", () => {
    const [, table = ""] = /kKeywords = \{(.*?)\};/s.exec(source("syntax/lexer.cpp")) ?? [];
    expect(kKeywords).toEqual([...table.matchAll(/"(\w+)"/g)].map(([, word]) => word));
    expect(kKeywords).toEqual(expect.arrayContaining([...kExpressionKeywords, ...kStatementKeywords]));
  });

  it("have all a line about them", () => {
    const all = [...kBuiltins, ...Object.values(kModules).flatMap(({ functions }) => functions)];
    expect(all.filter(({ doc }) => !/^\S.*\.$/.test(doc))).toEqual([]);
  });
});

it("parameters are shown as a call has them", () => {
  expect(parametersText("iterable= start?=")).toBe("iterable, [start]");
  expect(parametersText("sep! end! *")).toBe("…, [sep=], [end=]");
  expect(parametersText("")).toBe("");
});
