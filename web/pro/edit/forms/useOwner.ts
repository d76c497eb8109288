// The element that another one belongs to.
import { nameOfElement } from "../../../shared/edit/commands/command";
import { useEditing } from "../editing";

/** Nothing of what belongs to the document. */
export function useOwner(id: string): { readonly id: string; readonly name: string } | undefined {
  const tree = useEditing(({ session }) => session?.view);
  const parent = tree?.elements.get(id)?.parent ?? "";
  return tree === undefined || parent === "" ? undefined : { id: parent, name: nameOfElement(tree, parent) };
}
