// The test vectors of api/examples/edits, which drive the server's edits, too (tests/unit/core/edit/vectors_test.cpp).
import { describe, expect, it } from "vitest";
import type { Edit } from "../../generated/messages";
import { apply, type Applied } from "../../shared/edit/apply";
import { Refusal } from "../../shared/edit/refusal";
import type { Tree } from "../../shared/edit/tree";
import type { JsonObject } from "../../shared/json";
import type { Rejection } from "./server/conflicts";
import { History } from "./server/history";
import { documentText, textOf, treeOf, vector, vectorNames } from "./documents";

interface ApplyVector {
  readonly document: JsonObject;
  readonly edit: Edit;
  readonly result: JsonObject;
  readonly inverse: Edit;
}

interface RefuseVector {
  readonly document: JsonObject;
  readonly edit: Edit;
  readonly error: { readonly path: string; readonly code: string };
}

function applied(tree: Tree, edit: Edit): Applied {
  const result = apply(tree, edit);
  if (result instanceof Refusal) throw result;
  return result;
}

// The server makes the operations of a compound edit; a client applies them as any others.
describe("vectors of edits that are applied", () => {
  it.each([...vectorNames("apply."), ...vectorNames("compound.")])("%s", (name) => {
    const { document, edit, result, inverse } = vector(name) as ApplyVector;
    const after = applied(treeOf(document), edit);
    expect(documentText(after.tree)).toBe(documentText(treeOf(result)));
    expect(textOf(after.inverse)).toBe(textOf(inverse));
    expect(documentText(applied(after.tree, after.inverse).tree)).toBe(documentText(treeOf(document)));
  });
});

describe("vectors of edits that are refused", () => {
  it.each(vectorNames("refuse."))("%s", (name) => {
    const { document, edit, error } = vector(name) as RefuseVector;
    const refusal = apply(treeOf(document), edit);
    expect(refusal).toBeInstanceOf(Refusal);
    expect(refusal).toMatchObject(error);
  });
});

interface HistoryVector {
  readonly document: JsonObject;
  readonly steps: readonly {
    readonly author: string;
    readonly base?: number;
    readonly edit?: Edit;
    readonly undo?: true;
    readonly redo?: true;
    readonly accepted?: Edit;
    readonly rejected?: Rejection;
  }[];
  readonly result: JsonObject;
}

// The simulated server of the tests of sessions is held to what the server does.
describe("vectors of histories", () => {
  it.each(vectorNames("history."))("%s", (name) => {
    const { document, steps, result } = vector(name) as HistoryVector;
    const history = new History(treeOf(document));
    for (const { author, base = 0, edit, undo, redo, accepted, rejected } of steps) {
      const found = undo === true ? history.undo(author) : redo === true ? history.redo(author) : history.apply(author, base, edit ?? { operations: [] });
      expect("edit" in found ? found.edit : found).toEqual(accepted ?? rejected);
    }
    expect(documentText(history.tree)).toBe(documentText(treeOf(result)));
  });
});
