// What fields can offer: poses that were taught and labels that the camera knows, as far as this page can find out.
import { useMemo } from "react";
import { namedIn, type Named } from "../../shared/skills/named";
import { useTree } from "../editing";
import { useTaughtPoses } from "../poses";
import { useNamedElsewhere } from "../skills";

const sorted = (texts: readonly string[]): readonly string[] => [...new Set(texts)].filter((text) => text !== "").sort((a, b) => a.localeCompare(b));

/** What this document names, and all others. */
function useNamed(what: keyof Named): readonly string[] {
  const tree = useTree();
  const others = useNamedElsewhere();
  return useMemo(() => [...(tree === undefined ? [] : namedIn(tree)[what]), ...others.flatMap((each) => each[what])], [tree, others, what]);
}

export interface Poses {
  readonly names: readonly string[];
  /** The joints [rad] of those that were taught, by their names; nothing: it is not known yet which those are. */
  readonly joints: ReadonlyMap<string, readonly number[]> | undefined;
  /** Why those that were taught could not be read. */
  readonly problem: string | undefined;
}

/** Poses that documents name and those that were taught. */
export function usePoses(): Poses {
  const named = useNamed("poses");
  const taught = useTaughtPoses();
  return useMemo(() => {
    const joints = taught.isLoaded && taught.problem === undefined ? new Map(taught.poses.map(({ name, q }) => [name, q])) : undefined;
    return { names: sorted([...named, ...taught.poses.map(({ name }) => name)]), joints, problem: taught.problem };
  }, [named, taught]);
}

/** What the camera may know: the labels in all documents, as the service does not tell. */
export function useLabels(): readonly string[] {
  const named = useNamed("labels");
  return useMemo(() => sorted(named), [named]);
}
