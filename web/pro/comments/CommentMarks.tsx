// In the drawing, elements or painted: how many open comments a state has, and with it all that is in one that is drawn closed.
import { openComments } from "../../shared/edit/comments/comments";
import { CanvasLayer } from "../canvas/CanvasLayer";
import { useShownCanvas } from "../canvas/canvasView";
import type { Laid } from "../canvas/useDrawing";
import { goToComments } from "./goToComments";
import { useCommentMarks } from "./marks";

/** More marks would hide the drawing. */
const kMost = 60;

export function CommentMarks() {
  const laid = useShownCanvas()?.laid;
  return laid === undefined ? null : <Marks laid={laid} />;
}

function Marks({ laid: { drawing, tree } }: { readonly laid: Laid }) {
  const { own, inside } = useCommentMarks(tree);
  if (own.size === 0) return null;
  const marks = drawing.nodes.flatMap((node) => {
    const count = (own.get(node.path) ?? 0) + (node.open ? 0 : (inside.get(node.path) ?? 0));
    const id = tree.get(node.path)?.node.id;
    return count === 0 || id === undefined ? [] : [{ node, id, count }];
  });
  return (
    <CanvasLayer className="comment-marks">
      {marks.slice(0, kMost).map(({ node, id, count }) => (
        <button
          key={id}
          type="button"
          className="comment-mark"
          aria-label={`${openComments(count)} on ${node.path}`}
          title={openComments(count)}
          style={{ left: node.x + node.width, top: node.y }}
          onClick={(event) => {
            event.stopPropagation();
            goToComments(id);
          }}
        >
          {count}
        </button>
      ))}
    </CanvasLayer>
  );
}
