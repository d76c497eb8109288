// All that a person reads of these folders stands in their texts alone, so that another language is one more file in each.
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { describe, expect, it } from "vitest";
import { en as control } from "../../control/texts/en";
import { en as display } from "../../display/texts/en";
import { en as one } from "../../one/texts/en";
import { en as pairing } from "../../pairing/texts/en";
import { en as stop } from "../../stop/texts/en";
import { leaves, textsIn, textsInStyles } from "./find";

const web = fileURLToPath(new URL("../..", import.meta.url));

interface Folder {
  readonly name: string;
  readonly texts: unknown;
  /** At least so many, so that none is read by mistake. */
  readonly files: number;
  /** The entry of a page shows nothing, and says only what nobody should ever read. */
  readonly without?: readonly string[];
}
const kFolders: readonly Folder[] = [
  { name: "control", texts: control, files: 22 },
  { name: "display", texts: display, files: 23, without: ["main.tsx"] },
  { name: "one", texts: one, files: 50, without: ["main.tsx"] },
  { name: "pairing", texts: pairing, files: 8 },
  { name: "stop", texts: stop, files: 6 },
];

describe.each(kFolders)("the texts of web/$name", ({ name, texts, files, without = [] }) => {
  const folder = join(web, name);
  const all = readdirSync(folder, { recursive: true, encoding: "utf8" });

  it("stand in no other file of the folder", () => {
    const read = all.filter((file) => /\.tsx?$/.test(file) && !file.startsWith("texts") && !without.includes(file));
    expect(read.length).toBeGreaterThanOrEqual(files);
    expect(read.flatMap((file) => textsIn(readFileSync(join(folder, file), "utf8"), file).map((text) => `${file}: ${text}`))).toEqual([]);
  });

  it("stand in no style sheet", () => {
    expect(all.filter((file) => file.endsWith(".css")).flatMap((file) => textsInStyles(readFileSync(join(folder, file), "utf8")).map((text) => `${file}: ${text}`))).toEqual([]);
  });

  it("say something", () => {
    expect(leaves(texts).length).toBeGreaterThan(0);
    expect(leaves(texts).filter((text) => text.trim() === "")).toEqual([]);
  });
});

describe("a text in code", () => {
  it("would be found in an element, an attribute, a constant, a choice and a template", () => {
    expect(textsIn("const a = <p>Go on</p>;")).toEqual(["Go on"]);
    expect(textsIn('const a = <p title="next" className="one two" />;')).toEqual(["next"]);
    expect(textsIn("const a = <p>{b ? 'Not now' : `Saved as ${c}`}</p>;")).toEqual(["Not now", "Saved as "]);
    expect(textsIn('const a = <p aria-label={b ? "more" : `less ${c}`}>{b && "off"}</p>;')).toEqual(["more", "less ", "off"]);
    expect(textsIn('const kNames = { start: "Start", saving: "Saving…" };')).toEqual(["Start", "Saving…"]);
    expect(textsIn('throw new Error("the server does not answer");')).toEqual(["the server does not answer"]);
    expect(textsIn('const a = { kind: "part", key: "Escape" }; document.querySelector(".skills input");')).toEqual([]);
    expect(textsIn('const a = <p className={`one ${b ? "two three" : ""}`} data-kind={b ? "part" : "place"} />;')).toEqual([]);
  });
});

describe("a text in a style sheet", () => {
  it("would be found, and what it takes from the element would not", () => {
    expect(textsInStyles(`a::before { content: "Gripper: "; color: var(--ink); } b::after { content: 'now' }`)).toEqual(["Gripper: ", "now"]);
    expect(textsInStyles('a::before { content: attr(data-of); } b::before { content: "↗"; } p { align-content: start; }')).toEqual([]);
  });
});

describe("the guide of RACE-One", () => {
  it("says in one or two sentences what is to be done", () => {
    for (const step of ["cell", "camera", "part", "place", "application", "run"] as const) expect(one[step].todo.split(/[.!?](?:\s|$)/).filter((sentence) => sentence !== "").length, step).toBeLessThanOrEqual(2);
  });
});
