// Draws over the page what is dragged, and where it can go.
import { useDragShown } from "./shown";

export function DragLayer() {
  const shown = useDragShown();
  if (shown === undefined) return null;
  const { line, band, target, dimmed = [], text } = shown;
  return (
    <div className="drag-layer">
      <svg aria-hidden="true">
        {dimmed.map((box, i) => (
          <Box key={i} className="drag-dimmed" box={box} />
        ))}
        {target !== undefined && <Box className="drag-target" box={target} />}
        {band !== undefined && <Box className="drag-band" box={band} />}
        {line !== undefined && <line className="drag-line" x1={line.from.x} y1={line.from.y} x2={line.to.x} y2={line.to.y} />}
        {line !== undefined && <circle className="drag-end" cx={line.to.x} cy={line.to.y} r={4} />}
      </svg>
      {text !== undefined && (
        <p role="status" className={text.refused ? "is-refused" : undefined} style={{ left: text.at.x + 14, top: text.at.y + 16 }}>
          {text.text}
        </p>
      )}
    </div>
  );
}

const Box = ({ className, box }: { readonly className: string; readonly box: DOMRect }) => <rect className={className} x={box.x} y={box.y} width={box.width} height={box.height} rx={8} />;
