// A comment: who said it, when, and what, as plain text.
import { useState, type ReactNode } from "react";
import type { Comment } from "../../shared/edit/comments/comments";
import { timeText } from "../../shared/timeText";

interface Props {
  readonly comment: Comment;
  readonly hidesText?: boolean;
  readonly children?: ReactNode;
}

export function Said({ comment: { id, author, time, edited, text }, hidesText = false, children }: Props) {
  const [now] = useState(() => Date.now());
  return (
    <div className="said" data-comment={id}>
      <header>
        <b>{author}</b>
        <time dateTime={time}>
          {timeText(Date.parse(time), now)}
          {edited !== undefined && <span title={`Changed ${timeText(Date.parse(edited), now)}`}> · changed</span>}
        </time>
      </header>
      {!hidesText && <p className="said-text">{text}</p>}
      {children}
    </div>
  );
}
