// When the overview of a drawing stands in its corner: where it has room, and shows more than the canvas does.
import { shows, type Viewport } from "./fit";
import type { Size } from "./measure";

/** On a narrower canvas it would cover too much of the drawing [px]. */
const kLeastWidth = 900;

export const needsMiniMap = (viewport: Viewport, drawing: Size, canvas: Size): boolean => canvas.width >= kLeastWidth && !shows(viewport, drawing, canvas);
