// What fields can offer: poses that were taught, and labels of parts: what the camera sees now, what it knows, what documents name.
import { useEffect, useMemo } from "react";
import { useSelected } from "../../page/store";
import { offeredLabels, recognitionOf, type OfferedLabels } from "../../shared/skills/labels";
import { namedIn, type Named } from "../../shared/skills/named";
import { bystander, useRefusal, useSession } from "../client";
import { useTree } from "../editing";
import { useTaughtPoses } from "../poses";
import { useNamedElsewhere } from "../skills";
import { texts } from "../texts";
import { createSight } from "./sight";

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

export interface Labels extends OfferedLabels {
  readonly isLooking: boolean;
  /** Why it is not known what the camera sees, as it is told. */
  readonly problem: string | undefined;
  /** Asks the camera again; nothing: it cannot be asked. */
  readonly look: (() => void) | undefined;
}

const sight = createSight((service, operation) => bystander.callService(service, operation, {}));
const kNone: readonly string[] = [];

/** The labels that a field offers, for which the camera is asked once at each `step` that is opened, and when it is there again. */
export function useLabels(step: string): Labels {
  const named = useNamed("labels");
  const service = useSession(({ connection, services }) => (connection === "open" ? recognitionOf(services) : undefined));
  const refusal = useRefusal("call_service");
  const asked = refusal === undefined ? service : undefined;
  useEffect(() => {
    if (asked !== undefined) sight.look(asked);
  }, [step, asked]);
  const { isLooking, seen, known, problem } = useSelected(sight.store, (now) => now);
  const isThere = asked !== undefined;
  const offered = useMemo(() => offeredLabels((isThere ? seen : undefined) ?? kNone, known, named), [isThere, seen, known, named]);
  const { notAsked, noCamera, unknown } = texts.sight;
  const reason = refusal !== undefined ? notAsked(refusal) : !isThere ? noCamera : problem === undefined ? undefined : unknown(problem);
  return { ...offered, isLooking: isThere && isLooking, problem: reason, look: isThere ? () => sight.look(asked) : undefined };
}
