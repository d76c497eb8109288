import { describe, expect, it } from "vitest";
import type { RcmDocument } from "../../shared/model/model";
import { createModelLoader } from "../../shared/session/modelLoader";

/** A loader whose requests are answered by hand. */
function opened() {
  const answers: { readonly resolve: (model: RcmDocument) => void; readonly reject: (error: Error) => void }[] = [];
  const requests: string[] = [];
  const models: string[] = [];
  const errors: unknown[] = [];
  const fetchModel = (id: string) => {
    requests.push(id);
    return new Promise<RcmDocument>((resolve, reject) => answers.push({ resolve, reject }));
  };
  const loader = createModelLoader(fetchModel, { onModel: (id, key) => models.push(`${id} ${key}`), onError: (error) => errors.push(error) });
  const settle = () => new Promise((resolve) => setTimeout(resolve));
  const answer = (request: number) => {
    answers[request]?.resolve({} as RcmDocument);
    return settle();
  };
  const fail = (request: number) => {
    answers[request]?.reject(new Error("503"));
    return settle();
  };
  return { loader, requests, models, errors, answer, fail };
}

describe("a loader of models", () => {
  it("loads each edit of a run once, however often it is asked", async () => {
    const { loader, requests, models, answer } = opened();
    loader.load("1", "1/1");
    loader.load("1", "1/1");
    await answer(0);
    loader.load("1", "1/1");
    expect([requests, models]).toEqual([["1"], ["1 1/1"]]);
    loader.load("1", "2/2");
    await answer(1);
    expect([requests, models]).toEqual([["1", "1"], ["1 1/1", "1 2/2"]]);
  });
  it("says once that a load failed, and tries again with the next edit or when it is told to forget", async () => {
    const { loader, requests, models, errors, answer, fail } = opened();
    loader.load("1", "1/1");
    await fail(0);
    for (let i = 0; i < 100; ++i) loader.load("1", "1/1");
    expect([requests.length, errors.length]).toEqual([1, 1]);
    loader.load("1", "2/2");
    await fail(1);
    loader.forget();
    loader.load("1", "2/2");
    await answer(2);
    expect([requests.length, errors.length, models]).toEqual([3, 2, ["1 2/2"]]);
  });
  it("drops what an earlier request answers, so that the last edit stays", async () => {
    const { loader, models, errors, answer, fail } = opened();
    for (const key of ["1/1", "2/2", "3/3"]) loader.load("1", key);
    await answer(2);
    await answer(0);
    await fail(1);
    expect([models, errors]).toEqual([["1 3/3"], []]);
  });
});
