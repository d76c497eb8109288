// The button that makes an application, and what has failed: then it tries again.
import { texts } from "../texts";
import type { Making } from "./useMaking";

interface Props extends Making {
  readonly label: string;
  readonly making: string;
}

export function MakeButton({ busy, problem, make, label, making }: Props) {
  return (
    <>
      {problem !== undefined && <p className="problem" role="alert">{problem}</p>}
      <button type="button" className="main" disabled={busy} onClick={make}>
        {busy ? making : problem !== undefined ? texts.tryAgain : label}
      </button>
    </>
  );
}
