// What the camera saw at the moment of the past that is shown.
import { useEffect, useState } from "react";
import type { Core, RunPicture } from "../../generated/messages";
import { listedUpTo, pictureAt, type KeptPicture } from "../../shared/past/pictures";
import { api, problem } from "../client";

interface Props {
  readonly core: Core;
  /** The macro step that is looked at. */
  readonly step: number;
}

interface Listed {
  readonly run: string;
  /** Known up to this macro step. */
  readonly to: number;
  readonly pictures: readonly KeptPicture[];
}

/** The pictures of a run. */
function usePictures(core: Core, step: number): readonly KeptPicture[] | undefined {
  const run = core.id;
  const [listed, setListed] = useState<Listed>();
  const to = listedUpTo(core, step);
  const isKnown = listed?.run === run && listed.to >= step;
  useEffect(() => {
    if (isKnown) return;
    let current = true;
    api.pictures(run).then((pictures) => current && setListed({ run, to, pictures }), problem);
    return () => {
      current = false;
    };
  }, [run, to, isKnown]);
  return listed?.run === run ? listed.pictures : undefined;
}

/** The picture itself; while another one is loaded, that before. */
function usePicture(run: string, number: number | undefined): RunPicture | undefined {
  const [loaded, setLoaded] = useState<{ readonly run: string; readonly picture: RunPicture }>();
  useEffect(() => {
    if (number === undefined) return;
    let current = true;
    api.picture(run, number).then(
      (picture) => current && setLoaded({ run, picture }),
      () => undefined, // It was dropped meanwhile.
    );
    return () => {
      current = false;
    };
  }, [run, number]);
  return number !== undefined && loaded?.run === run ? loaded.picture : undefined;
}

export function PastPicture({ core, step }: Props) {
  const pictures = usePictures(core, step);
  const at = pictures && pictureAt(pictures, step);
  const picture = usePicture(core.id, at?.number);
  if (pictures === undefined || pictures.length === 0) return null;
  return (
    <section aria-label="Camera">
      <h3>Camera</h3>
      {at === undefined && <p className="quiet">No picture had been taken yet.</p>}
      {picture !== undefined && (
        <figure className="past-picture">
          <img src={`data:image/jpeg;base64,${picture.jpeg}`} alt={`What ${picture.service} saw in step ${picture.step}`} />
          <figcaption>
            <code>{picture.service}</code> in step {picture.step}, at {picture.time.toFixed(2)} s: the newest picture that somebody had asked for
          </figcaption>
        </figure>
      )}
    </section>
  );
}
