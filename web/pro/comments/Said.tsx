// A comment: who said it, when, and what, as plain text.
import type { ReactNode } from "react";
import type { Comment } from "../../shared/edit/comments/comments";
import { timeText } from "../../shared/edit/comments/timeText";

interface Props {
  readonly comment: Comment;
  readonly hidesText?: boolean;
  readonly children?: ReactNode;
}

export function Said({ comment: { id, author, time, edited, text }, hidesText = false, children }: Props) {
  return (
    <div className="said" data-comment={id}>
      <header>
        <b>{author}</b>
        <time dateTime={time}>
          {timeText(time, Date.now())}
          {edited !== undefined && <span title={`Changed ${timeText(edited, Date.now())}`}> · changed</span>}
        </time>
      </header>
      {!hidesText && <p className="said-text">{text}</p>}
      {children}
    </div>
  );
}
