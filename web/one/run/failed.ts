// What went wrong last in the run that is watched: seen while it happens, else found in the derivations of its end.
import { useEffect, useMemo, useState } from "react";
import { buildTree } from "../../shared/model/modelTree";
import { causes } from "../../shared/run/causes";
import { isBadOutcome } from "../../shared/run/controls";
import { watchedCore, type Session } from "../../shared/session/session";
import { failedIn, type Failed } from "../../shared/timeline/progress";
import type { Application } from "../../shared/timeline/read";
import { api, session, useCore, useSession } from "../client";
import { everyStep } from "../model";

/** So many macro steps back the reason of an end is looked for. */
const kSteps = 60;

export interface Failure extends Failed {
  /** The run in which it was. */
  readonly run: string;
  /** What the step itself has found out. */
  readonly why: string | undefined;
}

const kTrees = new WeakMap<object, ReturnType<typeof buildTree>>();
export function treeOfRun({ model }: Pick<Session, "model">): ReturnType<typeof buildTree> | undefined {
  if (model === undefined) return undefined;
  const tree = kTrees.get(model) ?? buildTree(model.root);
  kTrees.set(model, tree);
  return tree;
}

function whyOf(now: Session, id: string): string | undefined {
  const tree = treeOfRun(now);
  const path = tree === undefined ? undefined : [...tree.values()].find(({ node }) => node.id === id)?.path;
  const why = path === undefined ? undefined : now.run?.results.get(path)?.["why"];
  return typeof why === "string" && why !== "" ? why : undefined;
}

export function useFailure(application: Application | undefined): Failure | undefined {
  const core = useCore();
  const steps = useMemo(() => (application === undefined ? [] : everyStep(application)), [application]);
  const [failure, setFailure] = useState<Failure>();
  useEffect(() => {
    const look = () => {
      const now = session.get();
      const [tree, run] = [treeOfRun(now), watchedCore(now)];
      const failed = tree && failedIn(now.fired.ports, tree, steps);
      if (failed !== undefined && run !== undefined) setFailure({ ...failed, run: run.id, why: whyOf(now, failed.step.id) });
    };
    return session.listen(look);
  }, [steps]);
  const ended = core?.status === "ended" && isBadOutcome(core.outcome) ? core.id : undefined;
  const known = failure !== undefined && failure.run === ended;
  const model = useSession((s) => s.model);
  useEffect(() => {
    if (ended === undefined || known || model === undefined) return undefined;
    let current = true;
    const find = async () => {
      const now = session.get();
      const [tree, run] = [treeOfRun(now), watchedCore(now)];
      if (tree === undefined || run?.outcome === undefined) return;
      const derived = await api.derivations(run.id, Math.max(1, run.step - kSteps), run.step);
      const chain = causes(tree, derived, `${tree.keys().next().value ?? ""}.${run.outcome}`);
      const failed = failedIn(chain.map(({ address }) => address), tree, steps);
      if (current && failed !== undefined) setFailure({ ...failed, run: run.id, why: whyOf(now, failed.step.id) });
    };
    // Without it the page still says that it has failed.
    find().catch(() => undefined);
    return () => {
      current = false;
    };
  }, [ended, known, steps, model]);
  return failure !== undefined && failure.run === core?.id ? failure : undefined;
}
