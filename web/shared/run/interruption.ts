// An interrupted run in words: what happened, and what holds until somebody resumes it.
import type { Core } from "../../generated/messages";

export interface InterruptionText {
  readonly title: string;
  /** The message of the server. */
  readonly happened: string | undefined;
  /** With code in backquotes. */
  readonly holds: string;
}

export const isInterrupted = (core: Core): boolean => core.status === "interrupted";

/** What the page says of an interrupted core; nothing of any other. */
export function interruptionText(core: Core): InterruptionText | undefined {
  if (!isInterrupted(core)) return undefined;
  const happened = core.interruption?.message;
  if (core.interruption?.reason === "storage") {
    return {
      title: `Run ${core.id} is interrupted: its journal cannot be stored`,
      happened,
      holds: "It is as its journal says. Open calls are answered `unavailable`; none is sent again. Nothing moves until someone resumes, steps or stops it; while the disk fails, that is refused.",
    };
  }
  if (core.interruption?.reason === "failure") {
    return {
      title: `Run ${core.id} is interrupted: a step of it failed in the server`,
      happened,
      holds: "It is as its journal says. Open calls were answered `unavailable`; none is sent again. Nothing moves until someone resumes, steps or stops it.",
    };
  }
  if (core.interruption?.reason === "overload") {
    return {
      title: `Run ${core.id} is interrupted: more inputs waited than the server keeps`,
      happened,
      holds: "It is as its journal says; the inputs that waited are gone. Open calls were answered `unavailable`; none is sent again. Nothing moves until someone resumes, steps or stops it.",
    };
  }
  if (core.interruption?.reason === "deadline" || core.interruption?.reason === "stopped") {
    return {
      title: `Run ${core.id} is interrupted: a macro step did not end`,
      happened,
      holds: "It is as it was before that macro step, whose input is gone. Open calls were answered `unavailable`; none is sent again. Nothing moves until someone resumes, steps or stops it.",
    };
  }
  return {
    title: `Run ${core.id} is interrupted: the server ended and was started again`,
    happened,
    holds: "Open calls were answered `unavailable`; none is sent again. Nothing moves until someone resumes, steps or stops it.",
  };
}

/** What the page says once another process of the server answers: `interrupted`, the runs that it has found so. */
export function restartText(interrupted: readonly Core[]): string {
  if (interrupted.length === 0) return "No run was interrupted.";
  return interrupted.length === 1 ? "One run was interrupted:" : `${interrupted.length} runs were interrupted:`;
}

/** Those that the end of the server has interrupted, newest first. */
export const interruptedByRestart = (cores: readonly Core[]): readonly Core[] => cores.filter((core) => isInterrupted(core) && core.interruption?.reason === "restart").reverse();

/** The interrupted cores that are not watched, newest first. */
export function interruptedElsewhere(cores: readonly Core[], watched: string | undefined): readonly Core[] {
  return cores.filter((core) => isInterrupted(core) && core.id !== watched).reverse();
}
