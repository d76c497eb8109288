// An application is being made by the guide: whether it is there, and what has kept it from that.
import { useState } from "react";
import { isUnanswered } from "../../shared/api";
import { messageOf } from "../../shared/messageOf";
import { useEditing, useTree } from "../editing";
import { usePlace } from "../place";
import { texts } from "../texts";
import { makeApplication } from "./make";
import { isMade, type WantedSkill } from "./wanted";

/** `partly`: a try has ended before all was made. */
export type Made = "no" | "opening" | "partly" | "yes";

export interface Making {
  readonly made: Made;
  readonly busy: boolean;
  /** What has failed, in a sentence. */
  readonly problem: string | undefined;
  /** Also goes on with what is made partly. */
  readonly make: () => void;
}

function useMade(wanted: readonly WantedSkill[]): Made {
  const edit = usePlace((place) => place.edit);
  const tree = useTree();
  const unreadable = useEditing((now) => now.session?.unreadable);
  if (edit === undefined || unreadable !== undefined) return "no";
  if (tree === undefined) return "opening";
  return isMade(tree, wanted) ? "yes" : "partly";
}

/** A request that got no answer has the browser's own words for that. */
const reasonOf = (error: unknown): string => (isUnanswered(error) ? texts.frame.noAnswer : messageOf(error));

/** `wish`: the name of its document, if that is free; `title`: of its one task. */
export function useMaking(wish: string, title: string, wanted: readonly WantedSkill[]): Making {
  const made = useMade(wanted);
  const [busy, setBusy] = useState(false);
  const [failed, setFailed] = useState<string>();
  const make = async () => {
    setBusy(true);
    setFailed(undefined);
    try {
      await makeApplication(wish, title, wanted);
    } catch (error) {
      setFailed(reasonOf(error));
    }
    setBusy(false);
  };
  const problem = failed !== undefined ? texts.problem(failed) : made === "partly" && !busy ? texts.application.incomplete : undefined;
  return { made, busy, problem, make: () => void make() };
}
