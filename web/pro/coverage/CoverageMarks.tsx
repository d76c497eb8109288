// The signs of coverage in the drawing, over either canvas: a frame and a sign at what no test has come to, a sign where that is so in part.
import { CanvasLayer } from "../canvas/CanvasLayer";
import { kMostDrawn, useDrawnCoverage } from "./coverage";

/** What stands at a sign; the panel explains it. */
export const kSigns = { never: "0×", partly: "½" } as const;

export function CoverageMarks() {
  const drawn = useDrawnCoverage();
  if (drawn.length === 0) return null;
  return (
    <CanvasLayer className="coverage-marks">
      {drawn.slice(0, kMostDrawn).map(({ address, of, kind, text, box }) => (
        <span
          key={address}
          role="img"
          className={`coverage-mark is-${of} is-${kind}`}
          data-coverage={address}
          aria-label={`${address}: ${text}`}
          style={{ left: box.x, top: box.y, width: box.width, height: box.height }}
        >
          <span className={`coverage-sign is-${kind}`} aria-hidden="true">
            {kSigns[kind]}
          </span>
        </span>
      ))}
    </CanvasLayer>
  );
}
