// What a camera saw at a macro step of a run, by the pictures that are stored with it.
import type { Core, RunPictures } from "../../generated/messages";

import { isOver } from "../run/controls";

export type KeptPicture = RunPictures["pictures"][number];

/** The newest picture that was there in macro step `step`; nothing: no camera had taken one. */
export const pictureAt = (pictures: readonly KeptPicture[], step: number): KeptPicture | undefined => pictures.filter((picture) => picture.step <= step).at(-1);

/** Up to which macro step a list is complete that was asked for at step `step`: a run that goes on may have further pictures later. */
export const listedUpTo = (core: Pick<Core, "status">, step: number): number => (isOver(core) ? Number.POSITIVE_INFINITY : step);
