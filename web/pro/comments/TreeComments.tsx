// How many open comments a state has, beside its name in the tree.
import { openComments } from "../../shared/edit/comments/comments";
import { useCommentCount } from "./marks";

interface Props {
  readonly path: string;
  /** Nothing of what is in it is shown, so its comments count here. */
  readonly closed: boolean;
}

export function TreeComments({ path, closed }: Props) {
  const count = useCommentCount(path, closed);
  if (count === 0) return null;
  return (
    <span className="comment-mark" role="img" aria-label={openComments(count)} title={openComments(count)}>
      {count}
    </span>
  );
}
