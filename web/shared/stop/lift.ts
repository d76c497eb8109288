// How far the lower edge of what is seen is above that of the window: the height of a keyboard on the screen, below which STOP must not be.

/** As `visualViewport` has it [px]. */
export type SeenPart = Pick<VisualViewport, "offsetTop" | "height">;

export const liftOf = (windowHeight: number, { offsetTop, height }: SeenPart): number => Math.max(0, Math.round(windowHeight - offsetTop - height));
