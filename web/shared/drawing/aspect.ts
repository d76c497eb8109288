// The shape of the room for a drawing, of which there are a few: so layouts that are kept serve windows of many sizes.
import type { Size } from "./measure";

/** Width by height; each is a third more than the one before. */
export const kAspects: readonly number[] = [0.6, 0.8, 1.05, 1.4, 1.85, 2.4];

/** The aspect for which a drawing in a room of this size is laid out: the nearest, by ratio. */
export function aspectFor({ width, height }: Size): number {
  const far = (aspect: number) => Math.abs(Math.log((aspect * height) / Math.max(1, width)));
  return kAspects.reduce((best, aspect) => (far(aspect) < far(best) ? aspect : best));
}
