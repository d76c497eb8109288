// What becomes of the failures of a run, by the ports that fire.
import { describe, expect, it } from "vitest";
import type { JsonValue } from "../../shared/json";
import { buildTree } from "../../shared/model/modelTree";
import { readModel } from "../../shared/model/readModel";
import { kNoFailures, lastOf, openOf, pastOf, withFailures, type FailureLog } from "../../shared/timeline/failures";
import { readApplication } from "../../shared/timeline/read";
import { allSteps, type Step } from "../../shared/timeline/timeLine";
import { treeOf } from "../edit/documents";

const end = (name: string, more = {}) => ({ name, when: "True", meta: { id: `port-${name}`, ...more } });
const json = {
  rcm: 1 as const,
  root: {
    state: "Root", first: "Task", meta: { id: "root" },
    children: [
      {
        state: "Task", first: "Pick", meta: { id: "task" },
        children: [
          { state: "Pick", meta: { id: "pick", title: "Pick" }, ports: [end("success"), end("none", { advice: "See where it is.", title: "No part was found" })] },
          { state: "Handler", meta: { id: "handler" }, ports: [end("again"), end("retry"), end("skip"), end("abort"), end("give_up")] },
        ],
      },
    ],
  },
};
const model = buildTree(readModel(json).root);
const [pick] = allSteps(readApplication(treeOf(json as JsonValue)).root).filter(({ id }) => id === "pick");
const kFails = "Root/Task/Pick.none";
const handled = (port: string) => `Root/Task/Handler.${port}`;

/** The log of these firings, of a step that is handled so. */
function logOf(failure: Step["failure"], ...firings: readonly (readonly string[])[]): FailureLog {
  if (pick === undefined) throw new Error("there is no step");
  const steps = [{ ...pick, failure, handlers: ["handler"] }];
  return firings.reduce((log, ports, i) => withFailures(log, { fireCount: i + 1, ports }, { run: "7", model, steps, whyOf: () => "nothing red" }), kNoFailures);
}
const became = (log: FailureLog) => log.failures.map((each) => each.became);

describe("a failure", () => {
  it("is put right when its step is tried again, by itself or by a person", () => {
    expect(became(logOf({ kind: "retry", then: "stop" }, [kFails]))).toEqual([undefined]);
    expect(became(logOf({ kind: "retry", then: "stop" }, [kFails], [handled("again")]))).toEqual(["again"]);
    expect(became(logOf({ kind: "ask" }, [kFails, handled("retry")]))).toEqual(["again"]);
  });

  it("is left out, or stops the task, as a person says", () => {
    expect(became(logOf({ kind: "ask" }, [kFails], [handled("skip")]))).toEqual(["skipped"]);
    expect(became(logOf({ kind: "ask" }, [kFails], [handled("abort")]))).toEqual(["stopped"]);
  });

  it("that was tried often enough becomes what is said then", () => {
    const after = (then: "stop" | "next" | "leave" | "ask") => became(logOf({ kind: "retry", then }, [kFails], [handled("give_up")]));
    expect([after("stop"), after("next"), after("leave"), after("ask")]).toEqual([["stopped"], ["next"], ["left"], [undefined]]);
    expect(became(logOf({ kind: "retry", then: "ask" }, [kFails], [handled("give_up")], [handled("skip")]))).toEqual(["skipped"]);
  });

  it("is open until that is decided, also when what handled it first has given up", () => {
    const kAskThen = { kind: "retry", then: "ask" } as const;
    const asked = logOf(kAskThen, [kFails], [handled("again")], [kFails], [handled("give_up")]);
    expect(openOf(asked, "pick")).toMatchObject({ title: "No part was found" });
    expect(openOf(asked, "handler")).toBeUndefined();
    expect(openOf(logOf(kAskThen, [kFails], [handled("again")]), "pick")).toBeUndefined();
    expect(openOf(logOf(kAskThen, [kFails], [handled("give_up")], [handled("skip")]), "pick")).toBeUndefined();
  });

  it("of a step that nothing handles is decided at once", () => {
    expect([became(logOf({ kind: "stop" }, [kFails])), became(logOf({ kind: "next" }, [kFails])), became(logOf(undefined, [kFails]))]).toEqual([["stopped"], ["next"], ["elsewhere"]]);
  });

  it("has what its step has found out when it failed", () => {
    expect(logOf({ kind: "ask" }, [kFails]).failures[0]).toMatchObject({ title: "No part was found", why: "nothing red" });
  });
});

describe("the log", () => {
  it("reads each port once, also if it is told of the same firing again", () => {
    if (pick === undefined) throw new Error("there is no step");
    const about = { run: "7", model, steps: [{ ...pick, failure: { kind: "ask" as const }, handlers: ["handler"] }], whyOf: () => undefined };
    const once = withFailures(kNoFailures, { fireCount: 1, ports: [kFails] }, about);
    expect(withFailures(once, { fireCount: 1, ports: [kFails] }, about)).toBe(once);
    expect(became(withFailures(once, { fireCount: 1, ports: [kFails, handled("skip")] }, about))).toEqual(["skipped"]);
    expect(became(withFailures(once, { fireCount: 2, ports: [kFails] }, about))).toEqual([undefined, undefined]);
  });

  it("is another one of another run", () => {
    if (pick === undefined) throw new Error("there is no step");
    const log = logOf({ kind: "ask" }, [kFails]);
    expect(withFailures(log, { fireCount: 1, ports: [] }, { run: "8", model, steps: [pick], whyOf: () => undefined }).failures).toEqual([]);
  });

  it("tells what the run is past, the same in a row once, and not what is open", () => {
    const twice = logOf({ kind: "retry", then: "ask" }, [kFails], [handled("again")], [kFails], [handled("again")], [kFails], [handled("give_up")]);
    expect(pastOf(twice)).toMatchObject([{ became: "again", times: 2 }]);
  });

  it("has the reason of a bad end only if nothing has put it right", () => {
    expect(lastOf(logOf({ kind: "ask" }, [kFails], [handled("retry")]))).toBeUndefined();
    const stopped = logOf({ kind: "ask" }, [kFails], [handled("abort")]);
    expect(lastOf(stopped)).toMatchObject({ became: "stopped" });
    expect(pastOf(stopped, lastOf(stopped))).toEqual([]);
  });
});
