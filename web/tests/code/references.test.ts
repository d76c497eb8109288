// What a text names, and where: as core/edit/references.h finds it.
import { describe, expect, it } from "vitest";
import { referencesIn } from "../../shared/code/references";
import { tokensOf } from "../../shared/code/tokens";
import { valueSpans } from "../../shared/code/values";

const paths = (text: string): readonly string[] => referencesIn(text).map(({ names }) => names.join("."));
/** The pieces of the text at the spans of the last names. */
const last = (text: string): readonly string[] => referencesIn(text).map(({ spans }) => text.slice(spans.at(-1)?.from, spans.at(-1)?.to));

describe("tokens", () => {
  it("are words, numbers, strings, comments and operators", () => {
    expect(tokensOf("if par.x >= 1.5e-3: # so\n  y = f'{a}' // 0x1F").map(({ kind, text }) => `${kind} ${text}`)).toEqual([
      "keyword if", "name par", "operator .", "name x", "operator >=", "number 1.5e-3", "operator :", "comment # so", "name y", "operator =", "string f'{a}'", "operator //", "number 0x1F",
    ]);
  });

  it("have the offsets of the text, and lose none of it", () => {
    const text = "a = '''x\ny''' + \"ü\" $ 'open\nb";
    for (const { from, to, text: token } of tokensOf(text)) expect(text.slice(from, to)).toBe(token);
    expect(tokensOf(text).map(({ kind }) => kind)).toEqual(["name", "operator", "string", "operator", "string", "wrong", "wrong", "name"]);
  });
});

describe("references", () => {
  it("are paths of names, as long as they go", () => {
    expect(paths("res.n = chi.B.res.k.x + par.q[0].r")).toEqual(["res.n", "chi.B.res.k.x", "par.q"]);
    expect(paths("svc.robot.move(par.pose, speed=var.v)")).toEqual(["svc.robot.move", "par.pose", "var.v"]);
  });

  it("are entries by a text, too", () => {
    expect(paths(`par["x"] + var.get('y', par.z) + res.keys()`)).toEqual(["par.x", "var.y", "par.z", "res"]);
    expect(last(`par["x"]`)).toEqual([`"x"`]);
    expect(paths(`svc["S"].op.result or svc[par.s].op`)).toEqual(["svc.S.op.result", "par.s"]);
  });

  it("are keys that are looked for", () => {
    expect(paths(`"x" in par and 'y' not in res`)).toEqual(["par.x", "par", "res.y", "res"]);
    expect(paths(`"x" + "y" in par`)).toEqual(["par"]);
    expect(paths(`"x" in par.list`)).toEqual(["par.list"]);
  });

  it("stand in formatted texts", () => {
    const text = "print(f'{par.a:>{var.w}} {{par.no}} {res.b!r:.2f}', 'par.no')";
    expect(paths(text)).toEqual(["par.a", "var.w", "res.b"]);
    expect(last(text)).toEqual(["a", "w", "b"]);
  });

  it("are no attributes, names of arguments, or comments", () => {
    expect(paths("x.par.y + f(par=1) # par.z")).toEqual([]);
    expect(paths("par == 1")).toEqual(["par"]);
  });
});

describe("values of an expression", () => {
  const values = (text: string) => valueSpans(text, "A").map(({ from }) => from);
  it("are what it may give", () => {
    expect(values("'A'")).toEqual([0]);
    expect(values("'A' if par.m == 'A' else ('B' if 'A' else 'A')")).toEqual([0, 42]);
    expect(values("par.x and 'A' or 'A'")).toEqual([10, 17]);
    expect(values("['A', 'B'][par.i]")).toEqual([1]);
    expect(values("{'A': 'A', 'B': 'C'}[par.k]")).toEqual([6]);
  });

  it("are not what it looks at", () => {
    expect(values("par.d['A']")).toEqual([]);
    expect(values("f('A')")).toEqual([]);
    expect(values("['A']")).toEqual([]);
    expect(values("'A' == par.x")).toEqual([]);
    expect(values("['A' for i in par.l][0]")).toEqual([]);
  });
});
