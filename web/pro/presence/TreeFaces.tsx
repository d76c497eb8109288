// Who has selected a state, or something in one that is shown closed, beside its name in the tree.
import { initialsOf } from "../../shared/presence/names";
import { selectionsOf } from "../../shared/model/identity";
import { splitAddress } from "../../shared/model/modelTree";
import { useEditing, editedTree } from "../edit/editing";
import { useView } from "../client";
import { useOfOthers, type Other } from "./others";

const kNone: readonly never[] = [];

/** Paths of the nodes that they have selected, or a port of. */
function pathsOf({ person }: Other): readonly string[] {
  const model = editedTree();
  if (model === undefined) return kNone;
  const selections = selectionsOf(model);
  return (person.selection ?? []).flatMap((id) => {
    const at = selections.get(id);
    if (at === undefined) return [];
    return at.kind === "node" ? [at.path] : (splitAddress(at.address)?.path ?? []);
  });
}

interface Props {
  readonly path: string;
  readonly closed: boolean;
}

export function TreeFaces({ path, closed }: Props) {
  const edited = useView((v) => v.page === "edit");
  // The paths change with the model.
  useEditing((now) => now.session?.view);
  const here = useOfOthers((others) =>
    edited ? others.filter((other) => pathsOf(other).some((at) => at === path || (closed && at.startsWith(`${path}/`)))).map(({ name, person: { id, colour } }) => ({ id, name, colour })) : kNone,
  );
  return here.map(({ id, name, colour }) => (
    <span key={id} className={`tree-face person-${colour}`} role="img" data-person={id} aria-label={`${name} has selected this`} title={`${name} has selected this`}>
      {initialsOf(name)}
    </span>
  ));
}
