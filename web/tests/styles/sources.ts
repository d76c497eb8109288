// The files of a page as text, without comments, and the declarations of its style sheets.
import { readdirSync, readFileSync } from "node:fs";
import { join, relative } from "node:path";
import { fileURLToPath } from "node:url";

/** The novice page and the scene of the cell have the colours of the expert page. The page on trust has the colours of the display page; STOP, which is on all pages, uses those and its own, the controls those alone. */
export type PageName = "pro" | "one" | "cell" | "display" | "stop" | "control" | "trust";

const folderOf = (page: PageName): string => fileURLToPath(new URL(`../../${page}`, import.meta.url));

const kTokens: Readonly<Record<PageName, readonly string[]>> = { pro: ["styles/tokens.css"], one: ["../pro/styles/tokens.css"], cell: ["../pro/styles/tokens.css"], display: ["tokens.css"], stop: ["tokens.css", "../display/tokens.css"], control: ["../display/tokens.css"], trust: ["../display/tokens.css"] };

export interface Source {
  /** In the folder of the page, e.g. `styles/canvas.css`. */
  readonly name: string;
  readonly text: string;
}

export interface Declaration {
  readonly selector: string;
  readonly property: string;
  readonly value: string;
}

/** Comments of CSS and TypeScript; `//` behind a colon belongs to an address. */
const withoutComments = (text: string): string => text.replace(/\/\*[\s\S]*?\*\//g, "").replace(/(?<!:)\/\/.*$/gm, "");

export function sources(page: PageName, ending: RegExp): readonly Source[] {
  const folder = folderOf(page);
  return readdirSync(folder, { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile() && ending.test(entry.name))
    .map((entry) => join(entry.parentPath, entry.name))
    .map((path) => ({ name: relative(folder, path), text: withoutComments(readFileSync(path, "utf8")) }));
}

/** The innermost blocks of a style sheet, declaration by declaration. */
export function declarations(css: string): readonly Declaration[] {
  return [...css.matchAll(/([^{};]+)\{([^{}]*)\}/g)].flatMap(([, selector = "", body = ""]) =>
    body.split(";").flatMap((line) => {
      const colon = line.indexOf(":");
      return colon < 0 ? [] : [{ selector: selector.trim(), property: line.slice(0, colon).trim(), value: line.slice(colon + 1).trim() }];
    }),
  );
}

export interface Sheets {
  /** What the sheets that may have literal colours declare. */
  readonly tokens: readonly Declaration[];
  readonly others: readonly Source[];
}

export function sheetsOf(page: PageName): Sheets {
  const all = sources(page, /\.css$/);
  const tokens = kTokens[page].map((name) => join(folderOf(page), name));
  const isTokens = ({ name }: Source) => tokens.includes(join(folderOf(page), name));
  return { tokens: tokens.flatMap((sheet) => declarations(withoutComments(readFileSync(sheet, "utf8")))), others: all.filter((sheet) => !isTokens(sheet)) };
}
