// What RACE-One makes of an application by any changes is accepted by the real checker, and has the form of api/skills.md there, too.
import { execFileSync } from "node:child_process";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { documentOf } from "../../web/shared/edit/tree";
import { randomOf, setting } from "../../web/tests/edit/random";
import { RandomTask } from "../../web/tests/timeline/randomChanges";
import { binary } from "./fixture";

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
