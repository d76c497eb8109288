import { expect, it } from "vitest";
import { buildTree } from "../../shared/model/modelTree";
import { selectionAt } from "../../shared/session/view";
import { modelOf } from "../conformance";

it("an address selects a node or a port of the model, and nothing that the model has not got", () => {
  const tree = buildTree(modelOf("barrier-join").root);
  const [path, { node } = { node: undefined }] = [...tree].find(([, each]) => each.node.kind === "state" && each.node.ports.length > 0) ?? [""];
  const address = `${path}.${node?.kind === "state" ? node.ports[0]?.name : ""}`;
  expect(selectionAt(tree, path)).toEqual({ kind: "node", path });
  expect(selectionAt(tree, address)).toEqual({ kind: "port", address });
  for (const nothing of ["", `${path}/Nobody`, `${path}.nothing`, `${path}/Nobody.done`]) expect(selectionAt(tree, nothing), nothing).toBeUndefined();
});
