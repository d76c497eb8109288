// What a camera saw at a macro step of a run, by the pictures that are stored with it.
import type { RunPictures } from "../../generated/messages";

export type KeptPicture = RunPictures["pictures"][number];

/** The newest picture that was there in macro step `step`; nothing: no camera had taken one. */
export const pictureAt = (pictures: readonly KeptPicture[], step: number): KeptPicture | undefined => pictures.filter((picture) => picture.step <= step).at(-1);
