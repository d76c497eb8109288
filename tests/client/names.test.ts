// What is no data of api/conversations is tested in each client language: these tests of Python and of TypeScript have the same names.
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { project } from "./servers";

/** Of Python alone, and why. */
const kOnlyPython: Readonly<Record<string, string>> = {
  "a connection that cannot be looked at is closed": "fetch looks after its connections",
  "a file of an authority that cannot be used is named": "browser and Node read the authorities that they trust",
  "a module that is saved twice in a second is read anew": "Node keeps no compiled files",
  "a program with many files keeps its connections": "select is Python's",
  "both clients offer the same and say what it is": "there is one client in TypeScript",
  "the example of the package is the demo": "there is no such example",
  "the types hold": "npm run check",
  "what is generated is up to date": "it is the same generator, and the test there is of both",
};
/** Of TypeScript alone, and why. */
const kOnlyTypeScript: Readonly<Record<string, string>> = {
  "a process that is not known is refused and ends": "a WebSocket of JavaScript does not tell why the server refuses it, that of Python does",
  "a reader that leaves its loop ends the connection": "Python has a block for that, whose end every conversation has",
  "what is no part of a path is not sent": "a browser changes a path before it sends it",
  "the page of the template does what it says": "that of Python is api/tutorial.md (test_tutorial.py)",
  "the template has less than 30 lines": "as the one before",
  "the tests of both languages have the same names": "this one",
};

function titles(folder: string, files: RegExp, title: RegExp): readonly string[] {
  const found = readdirSync(join(project, folder)).filter((name) => files.test(name));
  return found.flatMap((name) => [...readFileSync(join(project, folder, name), "utf8").matchAll(title)].map(([, text = ""]) => text.replaceAll("_", " ")));
}

describe("the tests", () => {
  it("the tests of both languages have the same names", () => {
    const python = titles("tests/integration", /^test_python_(client.*|service)\.py$/, /^ {4}def test_(\w+)\(/gm);
    const typescript = titles("tests/client", /\.test\.ts$/, /^ {2}it\("([^"]+)"/gm);
    expect(python.length).toBeGreaterThan(30);
    expect(python.filter((name) => !(name in kOnlyPython)).sort()).toEqual(typescript.filter((name) => !(name in kOnlyTypeScript)).sort());
    expect(Object.keys(kOnlyPython).filter((name) => !python.includes(name))).toEqual([]);
    expect(Object.keys(kOnlyTypeScript).filter((name) => !typescript.includes(name))).toEqual([]);
  });
});
