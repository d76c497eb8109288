// What RACE-One makes of an application by any changes is accepted by the real checker, and has the form of api/skills.md there, too.
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { randomOf, setting } from "../../web/tests/edit/random";
import { RandomTask } from "../../web/tests/timeline/randomChanges";
import type { Command } from "../../web/shared/edit/commands/command";
import { apply, type Operation } from "../../web/shared/edit/apply";
import { plain, readExact } from "../../web/shared/edit/exact";
import { Refusal } from "../../web/shared/edit/refusal";
import { documentOf, type Tree } from "../../web/shared/edit/tree";
import type { JsonValue } from "../../web/shared/json";
import { addSkill, addTask } from "../../web/shared/timeline/changes/add";
import { loopSteps, repeatUntil } from "../../web/shared/timeline/changes/loop";
import { setValue } from "../../web/shared/timeline/changes/values";
import { emptyApp, skillDocument, stateNamed } from "../../web/tests/skills/fixture";
import { binary, demo } from "./fixture";

test("documents of random changes have no errors", () => {
  const seed = setting("RACE_SEED", Date.now() % 1_000_000);
  const folder = mkdtempSync(join(tmpdir(), "race-time-lines-"));
  try {
    const files = Array.from({ length: 60 }, (_, i) => {
      const task = new RandomTask(randomOf(seed + i));
      for (let n = 0; n < 5 + i; ++n) task.change();
      const file = join(folder, `${seed + i}.rcm.json`);
      writeFileSync(file, JSON.stringify(documentOf(task.tree)));
      return file;
    });
    const text = execFileSync(binary, ["check", "--json", ...files]).toString();
    const checked = JSON.parse(text) as { readonly files: readonly { readonly errors: readonly unknown[] }[] };
    expect(checked.files.map(({ errors }) => errors)).toEqual(files.map(() => []));
  } finally {
    rmSync(folder, { recursive: true });
  }
});

test("a loop until a step says so is run until then, and what follows is done once", () => {
  const folder = mkdtempSync(join(tmpdir(), "race-until-"));
  let ids = 0;
  const library = skillDocument("skills", JSON.parse(readFileSync(join(demo, "skills.rcm.json"), "utf8")) as JsonValue);
  const supplies = { newId: () => `n${++ids}`, documents: [library] };
  let tree: Tree = emptyApp;
  const take = (command: Command): string => {
    if ("reason" in command) throw new Error(command.reason);
    if (!("operations" in command.change)) throw new Error("the server makes this change");
    const applied = apply(tree, { operations: plain<readonly Operation[]>(command.change.operations) });
    if (applied instanceof Refusal) throw applied;
    ({ tree } = applied);
    return command.select ?? "";
  };
  const add = (task: string, index: number, name: string) => take(addSkill(tree, task, index, { document: "skills", id: stateNamed(library.tree, name) }, supplies));
  const task = take(addTask(tree, "root", 0, "Fill", supplies));
  const [count, wait] = [add(task, 0, "Count"), add(task, 1, "WaitTime")];
  take(setValue(tree, count, "target", readExact("4"), supplies));
  const loop = take(loopSteps(tree, [count, wait], 2, supplies));
  take(repeatUntil(tree, loop, { step: count, port: "reached" }, true, supplies));
  add(task, 1, "WaitTime");
  try {
    const file = join(folder, "fill.rcm.json");
    writeFileSync(file, JSON.stringify(documentOf(tree)));
    const lines = execFileSync(binary, ["run", file, "--cell", demo, "--fast", "--json"]).toString().trim().split("\n");
    const reports = lines.map((line) => JSON.parse(line) as { readonly outcome?: string; readonly fired?: readonly string[] });
    const fired = reports.flatMap((report) => report.fired ?? []);
    const times = (port: string) => fired.filter((each) => each.endsWith(port)).length;
    expect(reports.at(-1)?.outcome).toBe("success");
    expect([times("/Count.again"), times("/Body/Count.success"), times("/Body/Count.reached"), times("/Body.done"), times("/Body/WaitTime.success"), times("/Fill/WaitTime.success")]).toEqual([3, 3, 1, 1, 3, 1]);
  } finally {
    rmSync(folder, { recursive: true });
  }
});
