// The stop of a page on a server that is made up: what is asked, sent and told.
import { describe, expect, it } from "vitest";
import type { Control } from "../../generated/messages";
import { isStopPress } from "../../shared/stop/key";
import { liftOf } from "../../shared/stop/lift";
import { createStop, kAsk } from "../../shared/stop/stop";
import { viewOf } from "../../shared/stop/state";
import { fakeTime } from "./timers";

const kOwn = "http://127.0.0.1:9/api/v1/stop";
const free: Control = { stopped: null, mode: "execution", holder: null, request: null, leases: [], stop_ports: [{ port: 8080, stop_port: 9 }] };
const json = (body: unknown, status = 200): Promise<Response> => Promise.resolve(new Response(JSON.stringify(body), { status }));

function page(token?: string) {
  const time = fakeTime();
  const requests: string[] = [];
  let control: Control = free;
  let down: readonly string[] = [];
  const fetcher = ((address: string, init: RequestInit = {}) => {
    requests.push([init.method ?? "GET", address, ...(new Headers(init.headers).has("authorization") ? ["named"] : [])].join(" "));
    if (down.some((each) => address.endsWith(each))) return Promise.reject(new TypeError("lost"));
    if (address.endsWith("/stop")) control = { ...control, stopped: control.stopped ?? { by: token ?? "somebody", time: 7 } };
    if (address.endsWith("/reset")) control = { ...control, stopped: null };
    return json(address === kOwn ? { stopped: true } : control);
  }) as typeof fetch;
  const stop = createStop({ place: { protocol: "http:", hostname: "127.0.0.1", port: "8080" }, fetcher, token: () => token, after: time.after, now: time.now, nextFrame: () => () => undefined });
  return { stop, time, fetcher, requests, view: () => viewOf(stop.get()), fail: (...addresses: readonly string[]) => (down = addresses), set: (next: Control) => (control = next) };
}

describe("the stop of a page", () => {
  it("asks at once where it is served, and again while there is no stream", async () => {
    const { stop, time, requests, view } = page();
    stop.begin();
    await time.pass(kAsk + 1);
    expect(requests).toEqual(["GET /api/v1/control", "GET /api/v1/control"]);
    expect(view()).toBe("free");
    stop.connection("open");
    await time.pass(10 * kAsk);
    expect(requests.length, "once as the stream opens").toBe(3);
  });

  it("goes to both ports, and then knows who it was", async () => {
    const { stop, time, requests, view } = page("secret");
    stop.begin();
    await time.settle();
    stop.press();
    expect(view()).toBe("sending");
    await time.settle();
    expect(requests.slice(1)).toEqual([`POST ${kOwn}`, "POST /api/v1/stop named", "GET /api/v1/control named"]);
    expect(stop.get().stopped).toEqual({ by: "secret", time: 7 });
  });

  it("is stopped if one port answers, and says plainly if none does", async () => {
    const { stop, time, view, fail } = page();
    stop.begin();
    await time.settle();
    fail("8080/stop", "/api/v1/stop");
    stop.press();
    await time.pass(600);
    expect(view()).toBe("late");
    await time.pass(5000);
    expect(view()).toBe("failed");
    stop.dismiss();
    expect(view()).toBe("free");
    fail();
    stop.press();
    await time.settle();
    expect(view()).toBe("stopped");
  });

  it("of several presses tells the last one", async () => {
    const { stop, time, view, fail } = page();
    fail("/stop");
    stop.press();
    await time.pass(4000);
    stop.press();
    await time.pass(2000);
    expect(view(), "the first one is given up, the second is not").toBe("late");
    await time.pass(3000);
    expect(view()).toBe("failed");
  });

  it("is reset by an account, and nothing of it comes after that", async () => {
    const { stop, time, fetcher, requests, view, fail } = page();
    fail("/stop");
    stop.press();
    await time.pass(600);
    await stop.reset(fetcher);
    const sent = requests.length;
    await time.pass(10_000);
    expect([view(), requests.length]).toEqual(["free", sent]);
  });

  it("says why it is not reset", async () => {
    const { stop } = page();
    const message = "this needs the role operator";
    const refusing = () => json({ status: 403, title: "Forbidden", detail: message, errors: [{ path: "", code: "rights", message }] }, 403);
    await expect(stop.reset(refusing)).rejects.toThrow("this needs the role operator");
  });
});

describe("the key", () => {
  it("is F3 whatever is held besides, once for each press", () => {
    expect([isStopPress({ key: "F3", repeat: false }), isStopPress({ key: "F3", repeat: true }), isStopPress({ key: "F8", repeat: false })]).toEqual([true, false, false]);
  });
});

describe("a keyboard on the screen", () => {
  it("lifts STOP by its height, and nothing else does", () => {
    expect([liftOf(844, { offsetTop: 0, height: 508 }), liftOf(844, { offsetTop: 100, height: 508 }), liftOf(844, { offsetTop: 0, height: 844 }), liftOf(800, { offsetTop: 0, height: 844 })]).toEqual([336, 236, 0, 0]);
  });
});
