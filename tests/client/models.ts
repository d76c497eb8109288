// The small tasks that the tests of integration run, too.
import { execFileSync } from "node:child_process";
import { join } from "node:path";
import { project } from "./servers";

export interface Task {
  readonly rcm: 1;
  readonly name: string;
  readonly root: Readonly<Record<string, unknown>>;
}

const kScript = "import json, sys; sys.path.insert(0, sys.argv[1]); import models; print(json.dumps(getattr(models, sys.argv[2])(**json.loads(sys.argv[3]))))";

/** A task of tests/integration/models.py, with these arguments of its function. */
export const task = (kind: "hurrying" | "ticking", named: Readonly<Record<string, unknown>> = {}): Task =>
  JSON.parse(execFileSync("/usr/bin/python3", ["-B", "-c", kScript, join(project, "tests/integration"), kind, JSON.stringify(named)], { encoding: "utf8" })) as Task;
