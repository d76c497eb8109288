// What is painted on: a canvas of the page, or one aside.
export type Context = CanvasRenderingContext2D | OffscreenCanvasRenderingContext2D;
