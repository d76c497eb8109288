import { describe, expect, it } from "vitest";
import { oneAtATime } from "../shared/oneAtATime";

/** Requests that are answered by hand. */
function requests() {
  const asked: string[] = [];
  const open: { readonly answer: () => void; readonly fail: () => void }[] = [];
  const want = oneAtATime((wanted: string) => {
    asked.push(wanted);
    return new Promise<void>((resolve, reject) => open.push({ answer: resolve, fail: () => reject(new Error("lost")) }));
  });
  const end = async (how: "answer" | "fail") => {
    open.shift()?.[how]();
    await new Promise((resolve) => setTimeout(resolve, 0));
  };
  return { asked, want, end };
}

describe("one request at a time", () => {
  it("asks for what was wanted last meanwhile, once the answer is there", async () => {
    const { asked, want, end } = requests();
    for (const wanted of ["1", "2", "3"]) want(wanted);
    expect(asked).toEqual(["1"]);
    await end("answer");
    expect(asked).toEqual(["1", "3"]);
    await end("answer");
    want("4");
    expect(asked).toEqual(["1", "3", "4"]);
  });
  it("goes on after a request that failed", async () => {
    const { asked, want, end } = requests();
    want("1");
    want("2");
    await end("fail");
    expect(asked).toEqual(["1", "2"]);
  });
  it("asks for nothing that is not wanted any more", async () => {
    const { asked, want, end } = requests();
    want("1");
    want("2");
    want(undefined);
    await end("answer");
    expect(asked).toEqual(["1"]);
  });
});
