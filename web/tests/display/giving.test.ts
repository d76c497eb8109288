import { describe, expect, it } from "vitest";
import { giving } from "../../shared/display/giving";

describe("giving an answer", () => {
  const question = { id: 7, text: "Is the table empty?" };

  it("goes to the question that was seen, and to no other one", () => {
    expect(giving(question, question.text, undefined)).toBe("send");
    expect(giving(question, "Go on?", undefined)).toBe("gone");
    expect(giving(undefined, question.text, undefined)).toBe("gone");
  });
  it("is done once that question is not shown any more", () => {
    expect(giving(question, question.text, 7)).toBe("wait");
    expect(giving(undefined, question.text, 7)).toBe("given");
  });
  it("is done, too, when the same is asked again", () => expect(giving({ ...question, id: 8 }, question.text, 7)).toBe("given"));
});
