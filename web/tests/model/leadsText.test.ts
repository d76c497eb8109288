import { expect, it } from "vitest";
import * as schema from "../../generated/validators";
import { check } from "../../shared/messages/check";
import { leadsText } from "../../shared/model/leadsText";
import { buildTree } from "../../shared/model/modelTree";
import { readModel } from "../../shared/model/readModel";

it("says where each port leads, and nowhere only where nothing reads it", () => {
  const ports = [{ name: "next", when: "True", to: "B" }, { name: "over", when: "True" }, { name: "lost", when: "True" }];
  const native = { rcm: 1, root: { state: "Root", first: "A", children: [{ state: "A", ports }, { state: "B" }], ports: [{ name: "done", when: "chi.A.port.over" }] } };
  const tree = buildTree(readModel(check(schema.native, { document: native, origin: {} }).document).root);
  const text = (path: string, name: string, to?: string) => leadsText({ name, ...(to !== undefined && { to }) }, path, tree);
  expect(text("Root/A", "next", "B")).toBe("Leads to B.");
  expect(text("Root/A", "over")).toBe("The state around it is left through done, which reads it.");
  expect(text("Root/A", "lost")).toBe("Leads nowhere, and no port of the state around reads it.");
  // The drawing has an edge out of the task.
  expect(text("Root", "done")).toBe("Ends the task: the run is over when it fires.");
});
