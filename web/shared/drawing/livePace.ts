// When what a run changes over the still drawing is painted anew.

/** The view is at rest when it has not moved for so long [ms]. */
export const kRest = 120;
/** From one painting to the next, at least [ms]: while the view is at rest, and while it moves. Then what was painted moves with the view, as painting
 *  it in each frame would slow the movement down. */
const kPeriod = { resting: 30, moving: 100 };

/** `now`, when it was `painted` last and when the view has `moved` last [ms]. */
export const isLiveDue = (now: number, painted: number, moved: number): boolean => now - painted >= (now - moved < kRest ? kPeriod.moving : kPeriod.resting);
