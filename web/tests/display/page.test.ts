import { describe, expect, it } from "vitest";
import { applyDisplayEvent, canAnswer, firstPage, nameOf, placeOf, type DisplayEvent, type DisplayPage } from "../../shared/display/page";
import type { Display, Question } from "../../generated/messages";

const after = (...events: readonly DisplayEvent[]): DisplayPage => events.reduce(applyDisplayEvent, firstPage("main"));
const shows = (question?: Question): DisplayEvent => ({ type: "content", content: question === undefined ? { display: "main" } : { display: "main", question } });
const open: DisplayEvent = { type: "connection", connection: "open" };
const buttons = (id: number): Question => ({ id, text: "Go?", buttons: ["Yes"] });
const width = (id: number): Question => ({ id, text: "How wide?", number: { unit: "m", min: 0, max: 1, value: 0.5 } });

describe("the name in the address", () => {
  it("is main if there is none", () => {
    expect(nameOf("")).toBe("main");
    expect(nameOf("?name=tool-phone_2")).toBe("tool-phone_2");
  });
  it("is refused where the server would", () => {
    for (const search of ["?name=", "?name=all", "?name=a%20b", "?name=a/b", `?name=${"x".repeat(33)}`]) expect(nameOf(search)).toBeUndefined();
  });
});

describe("the place in the address", () => {
  it("is none if there is none, and what the server decides about otherwise", () => {
    expect([placeOf(""), placeOf("?name=left"), placeOf("?name=left&place=gripper"), placeOf("?place=")]).toEqual([undefined, undefined, "gripper", ""]);
  });
});

describe("a question", () => {
  it("can be answered once, while the page is connected", () => {
    expect(canAnswer(after(shows(buttons(1))))).toBe(false);
    expect(canAnswer(after(open, shows(buttons(1))))).toBe(true);
    expect(canAnswer(after(open, shows(buttons(1)), { type: "sent" }))).toBe(false);
    expect(canAnswer(after(open, shows(buttons(1)), { type: "connection", connection: "lost" }))).toBe(false);
  });
  it("that follows another one can be answered again", () => {
    expect(canAnswer(after(open, shows(buttons(1)), { type: "sent" }, shows(buttons(2))))).toBe(true);
  });
  it("can be answered again if the answer was lost with the connection", () => {
    const lost: DisplayEvent = { type: "connection", connection: "lost" };
    expect(canAnswer(after(open, shows(buttons(1)), { type: "sent" }, lost, open, shows(buttons(1))))).toBe(true);
  });
});

describe("the entry", () => {
  const key: DisplayEvent = { type: "key", key: "2" };
  it("starts from the proposed number and goes with its question", () => {
    expect(after(shows(width(1))).entry).toBe("0.5");
    expect(after(shows(width(1)), key).entry).toBe("0.52");
    expect(after(shows(width(1)), key, shows(width(2))).entry).toBe("0.5");
    expect(after(shows(width(1)), key, shows()).entry).toBe("");
  });
  it("stays when something else on the display changes, or the connection is lost", () => {
    const content: Display = { display: "main", question: width(1), message: { text: "Hurry", buttons: [] } };
    expect(after(shows(width(1)), key, { type: "content", content }).entry).toBe("0.52");
    expect(after(shows(width(1)), key, { type: "connection", connection: "lost" }, shows(width(1))).entry).toBe("0.52");
  });
});

describe("a problem", () => {
  it("is over when the server shows something", () => {
    const refused = after({ type: "problem", text: "64 displays are connected already" });
    expect(refused.problem).toBe("64 displays are connected already");
    expect(applyDisplayEvent(refused, shows()).problem).toBeUndefined();
  });
});
