// What the camera sees now, apart from other choices: it is said how that is known, or why it is not, and the camera looks again at a press.
import type { ReactNode } from "react";
import { texts } from "../texts";
import type { Labels } from "./known";

const t = texts.sight;

function told({ isLooking, problem, seen }: Labels): string {
  if (isLooking) return t.looking;
  if (problem !== undefined) return problem;
  return seen.length === 0 ? t.nothing : t.seen;
}

/** `children`: the choices that are seen. */
export function SightFrame({ labels, children }: { readonly labels: Labels; readonly children: ReactNode }) {
  return (
    <div className="sight" role="group" aria-label={t.seen}>
      <p role="status">{told(labels)}</p>
      {children}
      {labels.look !== undefined && (
        <button type="button" onClick={labels.look}>
          {t.again}
        </button>
      )}
    </div>
  );
}
