// While the cell is stopped: by whom, since when, what that means, and the way to the reset.
import { useState } from "react";
import { kStoppedMeans, stoppedText } from "../shared/stop/texts";
import type { Stopped } from "../shared/stop/state";
import { useStop } from "./useStop";
import { ResetDialog } from "./ResetDialog";
import { texts } from "./texts";

const t = texts.banner;

interface Props {
  /** Why the stop cannot be reset by this person, or now. */
  readonly refusal: string | undefined;
  /** Of the account. */
  readonly fetcher: typeof fetch;
}

export function StoppedBanner({ refusal, fetcher }: Props) {
  const stopped = useStop((stop) => stop.stopped);
  return stopped ? <Banner stopped={stopped} refusal={refusal} fetcher={fetcher} /> : null;
}

const textNow = (stopped: Stopped): string => stoppedText(stopped, Date.now());

function Banner({ stopped, refusal, fetcher }: Props & { readonly stopped: Stopped }) {
  const [asks, setAsks] = useState(false);
  return (
    <section className="stopped-banner" aria-label={t.name}>
      <p role="alert">
        <strong>{textNow(stopped)}</strong> <span>{kStoppedMeans}</span>
      </p>
      <div>
        <button type="button" aria-haspopup="dialog" disabled={refusal !== undefined} title={refusal} onClick={() => setAsks(true)}>
          {t.reset}
        </button>
        {refusal !== undefined && <small>{t.refused(refusal)}</small>}
      </div>
      {asks && refusal === undefined && <ResetDialog fetcher={fetcher} onClose={() => setAsks(false)} />}
    </section>
  );
}
