// Assistance in orchestration on the services of a real server: no operation that the demo calls is marked where it calls it.
import { unreachableOperations, type CodePlace } from "../../web/shared/orchestration/unreachable";
import { callsIn } from "../../web/shared/orchestration/calls";
import { editedModel } from "../../web/shared/edit/editedModel";
import { Refusal } from "../../web/shared/edit/refusal";
import { readTree } from "../../web/shared/edit/tree";
import type { JsonValue } from "../../web/shared/json";
import type { HostedService } from "../../web/generated/messages";
import type { State } from "../../web/shared/model/model";
import { openFixture, type Fixture } from "./fixture";

let fixture: Fixture;
beforeAll(async () => void (fixture = await openFixture()));
afterAll(() => fixture.close());

/** All states from here on with their paths. */
const all = (state: State, path: string): readonly (readonly [string, State])[] =>
  [[path, state] as const, ...state.children.flatMap((child) => (child.kind === "state" ? all(child, `${path}/${child.name}`) : []))];

it.each(["pick", "demonstrator"])("marks nothing that %s calls, and what needs another state first", async (name) => {
  const { services } = (await fixture.send("GET", "/services")) as { services: readonly HostedService[] };
  const tree = readTree(((await fixture.send("GET", `/documents/${name}`)) as { document: JsonValue }).document);
  if (tree instanceof Refusal) throw tree;
  const model = editedModel(tree);
  let called = 0;
  let marked = 0;
  for (const [path, state] of [model.root, ...model.library].flatMap((top) => all(top, top.name))) {
    const places: readonly (readonly [string, CodePlace])[] = [[state.entry ?? "", { code: "entry", before: "" }], [state.exit ?? "", { code: "exit", before: "" }], [state.actions.map((action) => action.do).join("\n"), { code: "action" }]];
    for (const [code, place] of places) {
      const found = unreachableOperations(model, services, path, place);
      marked += found.size;
      for (const { service, operation } of callsIn(code)) {
        called += 1;
        expect(found.get(`svc.${service ?? ""}.${operation}`), `${path} ${place.code}`).toBeUndefined();
      }
    }
  }
  expect(called).toBeGreaterThan(4);
  expect(marked).toBeGreaterThan(0);
});
