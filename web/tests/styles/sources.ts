// The files of the expert page as text, without comments, and the declarations of its style sheets.
import { readdirSync, readFileSync } from "node:fs";
import { join, relative } from "node:path";
import { fileURLToPath } from "node:url";

const page = fileURLToPath(new URL("../../pro", import.meta.url));

export interface Source {
  /** From web/pro, e.g. `styles/canvas.css`. */
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

export function sources(ending: RegExp): readonly Source[] {
  return readdirSync(page, { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile() && ending.test(entry.name))
    .map((entry) => join(entry.parentPath, entry.name))
    .map((path) => ({ name: relative(page, path), text: withoutComments(readFileSync(path, "utf8")) }));
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

export const tokensSheet = "styles/tokens.css";
