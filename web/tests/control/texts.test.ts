// What is said of the controls, and which requests tell that a page has them.
import { describe, expect, it } from "vitest";
import { withControls } from "../../shared/control/header";
import { answerRequest, setMode } from "../../shared/control/requests";
import { holderText, leftToAnswer, linkWarning, modeText } from "../../shared/control/texts";

describe("who has the controls", () => {
  const holder = { number: 4, by: "alice" };
  it("is said by name", () => {
    expect([holderText(null, undefined), holderText(holder, undefined), holderText(holder, 4), holderText(null, 5), holderText(holder, 3)]).toEqual([
      "Nobody has the controls", "alice has the controls", "You have the controls", "You have the controls", "alice has the controls",
    ]);
  });
  it("is warned of when it is this page no more, with the reason", () => {
    expect(linkWarning({ kind: "lost", why: "this page was hidden" }, null)).toMatchObject({ title: "You have LOST the controls", why: "this page was hidden" });
    expect(linkWarning({ kind: "lost", why: "you have them no more" }, holder)?.why).toBe("you have them no more; alice has them now");
    expect(linkWarning({ kind: "refused", why: "bob has them" }, holder)).toEqual({ title: "You do not get the controls", why: "bob has them" });
    expect(linkWarning({ kind: "taking" }, null)).toBeUndefined();
  });
});

describe("the mode", () => {
  it("is a word, and how fast the tool is at most", () => expect([modeText("execution"), modeText("programming")]).toEqual(["Execution mode", "Programming mode, reduced speed 250 mm/s"]));
});

describe("the time to answer", () => {
  it("is 30 s, and never less than nothing", () => expect([0, 1, 1500, 30_000, 99_000].map((now) => leftToAnswer(0, now))).toEqual([30, 30, 29, 0, 0]));
});

describe("requests that need the controls", () => {
  const sent = async (path: string, method: string, secret: string | undefined) => {
    let header: string | null = null;
    const fetcher: typeof fetch = (_, init) => {
      header = new Headers(init?.headers).get("race-control");
      return Promise.resolve(new Response("{}"));
    };
    await withControls(fetcher, () => secret)(path, { method, headers: { "content-type": "application/json" } });
    return header;
  };
  it.each(["start", "resume", "step", "force", "confirm_edit"])("have the secret: %s", async (what) => {
    expect([await sent(`/api/v1/cores/7/${what}`, "POST", "s"), await sent(`/api/v1/cores/7/${what}`, "POST", undefined)]).toEqual(["s", null]);
  });
  it("have it where the mode is set, the cell is reset and a service is called, and nowhere else", async () => {
    expect([await sent("/api/v1/control/mode", "PUT", "s"), await sent("/api/v1/cell/reset", "POST", "s"), await sent("/api/v1/services/robot/calls", "POST", "s"), await sent("/api/v1/cores", "POST", "s"), await sent("/api/v1/cores/7/stop", "POST", "s"), await sent("/api/v1/stop", "POST", "s")]).toEqual(["s", "s", "s", null, null, null]);
  });
});

describe("what is asked of the server", () => {
  const control = { stopped: null, mode: "programming", holder: null, request: null, leases: [], stop_ports: [] };
  const answering = (status: number, body: unknown) => {
    const seen: unknown[] = [];
    const fetcher: typeof fetch = (input, init) => {
      seen.push([init?.method, input, init?.body]);
      return Promise.resolve(new Response(JSON.stringify(body), { status }));
    };
    return { fetcher, seen };
  };
  it("is the mode, or the answer to who asks", async () => {
    const { fetcher, seen } = answering(200, control);
    expect(await setMode(fetcher, "programming")).toEqual(control);
    await answerRequest(fetcher, 3, false);
    expect(seen).toEqual([["PUT", "/api/v1/control/mode", '{"mode":"programming"}'], ["POST", "/api/v1/control/answer", '{"request":3,"allow":false}']]);
  });
  it("fails with what the server says", async () => {
    const problem = { type: "about:blank", title: "Conflict", status: 409, detail: "take the controls of the cell first", errors: [{ code: "leased", path: "", message: "take the controls of the cell first" }] };
    await expect(setMode(answering(409, problem).fetcher, "execution")).rejects.toMatchObject({ name: "RaceError", status: 409, message: "take the controls of the cell first" });
  });
});
