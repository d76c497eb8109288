// What went wrong in the run that is watched: now, as its state says; before, as it was seen; and of its end, found in its derivations if it was not seen.
import { useEffect, useMemo, useState } from "react";
import { buildTree } from "../../shared/model/modelTree";
import { causes } from "../../shared/run/causes";
import { isBadOutcome, isOver } from "../../shared/run/controls";
import { watchedCore, type Session } from "../../shared/session/session";
import { kNoFailures, lastOf, openOf, pastOf, withFailures, type FailureLog, type PastFailure } from "../../shared/timeline/failures";
import { failedIn, type Failed, type Progress } from "../../shared/timeline/progress";
import { posesToTeach } from "../../shared/timeline/teachable";
import type { Application } from "../../shared/timeline/read";
import { api, session, useCore, useSession } from "../client";
import { everyStep } from "../model";

/** So many macro steps back the reason of an end is looked for. */
const kSteps = 60;

export interface Failure extends Failed {
  /** What the step itself has found out. */
  readonly why: string | undefined;
  /** What of its place can be taught again. */
  readonly poses: readonly string[];
}

const kTrees = new WeakMap<object, ReturnType<typeof buildTree>>();
export function treeOfRun({ model }: Pick<Session, "model">): ReturnType<typeof buildTree> | undefined {
  if (model === undefined) return undefined;
  const tree = kTrees.get(model) ?? buildTree(model.root);
  kTrees.set(model, tree);
  return tree;
}

const pathOf = (now: Session, id: string): string | undefined => [...(treeOfRun(now)?.values() ?? [])].find(({ node }) => node.id === id)?.path;

function whyOf(now: Session, id: string): string | undefined {
  const path = pathOf(now, id);
  const why = path === undefined ? undefined : now.run?.results.get(path)?.["why"];
  return typeof why === "string" && why !== "" ? why : undefined;
}

function withPoses(now: Session, failed: Failed & Partial<Pick<Failure, "why">>): Failure {
  const path = pathOf(now, failed.step.id);
  return { ...failed, why: failed.why ?? whyOf(now, failed.step.id), poses: posesToTeach(failed, path === undefined ? undefined : now.run?.parameters.get(path)) };
}

export interface Failures {
  /** Nobody has put it right: it is being handled, or the run has ended by it. */
  readonly now: Failure | undefined;
  /** What the run is past, oldest first. */
  readonly past: readonly PastFailure[];
}

/** `progress`: where the run is. */
export function useFailures(application: Application | undefined, progress: Progress): Failures {
  const core = useCore();
  const steps = useMemo(() => (application === undefined ? [] : everyStep(application)), [application]);
  const log = useLog(steps, core?.id);
  const isBadEnd = core !== undefined && (core.status === "aborted" || (core.status === "ended" && isBadOutcome(core.outcome)));
  const seen = isBadEnd ? lastOf(log) : undefined;
  const found = useCauseOfEnd(steps, isBadEnd && core.status === "ended" && seen === undefined ? core.id : undefined);
  const run = useSession((s) => s.run);
  const model = useSession((s) => s.model);
  const isGoing = core !== undefined && !isOver(core);
  const now = useMemo(() => {
    const [tree, step] = [treeOfRun({ model }), progress.now.at(-1)];
    if (!isGoing) return seen === undefined ? found : withPoses(session.get(), seen);
    if (!progress.failing || tree === undefined || step === undefined || run === undefined) return undefined;
    // Its port is not active any more when what handled it first has given up.
    const failed = failedIn(run.ports, tree, [step]) ?? openOf(log, step.id);
    return failed && withPoses(session.get(), failed);
  }, [isGoing, seen, found, progress, run, model, log]);
  return { now, past: useMemo(() => pastOf(log, seen), [log, seen]) };
}

/** What has failed since this page watches the run. */
function useLog(steps: ReturnType<typeof everyStep>, run: string | undefined): FailureLog {
  const [log, setLog] = useState(kNoFailures);
  useEffect(() => {
    const look = () => {
      const now = session.get();
      const [model, watched] = [treeOfRun(now), watchedCore(now)];
      if (model !== undefined && watched !== undefined) setLog((before) => withFailures(before, now.fired, { run: watched.id, model, steps, whyOf: (id) => whyOf(now, id) }));
    };
    return session.listen(look);
  }, [steps]);
  return log.run === run ? log : kNoFailures;
}

/** The failure by which a run has ended that was not seen; `ended`: that run, if it is wanted. */
function useCauseOfEnd(steps: ReturnType<typeof everyStep>, ended: string | undefined): Failure | undefined {
  const [found, setFound] = useState<{ readonly run: string; readonly failure: Failure }>();
  const model = useSession((s) => s.model);
  const isKnown = found !== undefined && found.run === ended;
  useEffect(() => {
    if (ended === undefined || isKnown || model === undefined) return undefined;
    let current = true;
    const find = async () => {
      const now = session.get();
      const [tree, run] = [treeOfRun(now), watchedCore(now)];
      if (tree === undefined || run?.outcome === undefined) return;
      const derived = await api.derivations(run.id, Math.max(1, run.step - kSteps), run.step);
      const chain = causes(tree, derived, `${tree.keys().next().value ?? ""}.${run.outcome}`);
      const failed = failedIn(chain.map(({ address }) => address), tree, steps);
      if (current && failed !== undefined) setFound({ run: run.id, failure: withPoses(now, failed) });
    };
    // Without it the page still says that it has failed.
    find().catch(() => undefined);
    return () => {
      current = false;
    };
  }, [ended, isKnown, steps, model]);
  return isKnown ? found.failure : undefined;
}
