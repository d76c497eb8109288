import { describe, expect, it } from "vitest";
import { countErrors, errorsText } from "../../shared/run/errorsText";
import { documentText, placeText, refusalToStart } from "../../shared/session/draft";

describe("a document with errors", () => {
  it("is listed as a draft with the number of its errors", () => {
    expect(documentText({ name: "pick", errors: 2 })).toBe("pick · draft, 2 errors");
    expect(errorsText(1)).toBe("1 error");
  });
  it("may have more errors than are counted and listed", () => {
    expect(errorsText(200)).toBe("200 errors");
    expect(errorsText(201)).toBe("more than 200 errors");
    const errors = [{ path: "Root", code: "type", message: "expected bool" }];
    expect([countErrors(errors, undefined), countErrors(errors, true)]).toEqual([1, 2]);
  });
  it("cannot be started, and the reason names it", () => expect(refusalToStart({ name: "pick", errors: 1 })).toBe("pick is a draft with 1 error: it cannot be started"));
  it("is no draft without errors, or if the server counts none", () => {
    for (const summary of [{ name: "pick", errors: 0 }, { name: "pick" }]) expect([documentText(summary), refusalToStart(summary)]).toEqual(["pick", undefined]);
  });
});

describe("placeText", () => {
  it("says where an error is, as exactly as the server does", () => {
    const error = { path: "Root/Pick", code: "type", message: "expected bool" };
    expect(placeText(error)).toBe("Root/Pick");
    expect(placeText({ ...error, line: 2 })).toBe("Root/Pick, line 2");
    expect(placeText({ ...error, line: 2, column: 7 })).toBe("Root/Pick, line 2, column 7");
    expect(placeText({ ...error, path: "" })).toBe("the whole document");
  });
});
