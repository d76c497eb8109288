// The question before an application is left whose edits the server has not taken.
import { useModal } from "../page/useModal";
import { useEditing } from "./editing";
import { leaveNow, stay, useIsLeaving } from "./leaving";
import { texts } from "./texts";
import { questionOf } from "./unsaved";

const t = texts.leave;

export function LeaveQuestion() {
  return useIsLeaving() ? <Question /> : null;
}

function Question() {
  const dialog = useModal();
  const waiting = useEditing((now) => now.session?.pending.length ?? 0);
  const refused = useEditing((now) => now.refused);
  const { title, means, leave, loses } = questionOf({ waiting, refused });
  return (
    <dialog ref={dialog} className="leaving" role="alertdialog" aria-labelledby="leaving-title" aria-describedby="leaving-means" onClose={stay}>
      <div role="status">
        <h2 id="leaving-title">{title}</h2>
        <div id="leaving-means">
          {means.map((text) => (
            <p key={text}>{text}</p>
          ))}
          {refused.length > 0 && (
            <ul aria-label={t.refusedList}>
              {refused.map(({ what, why }, i) => (
                <li key={i}>{t.why(what, why)}</li>
              ))}
            </ul>
          )}
        </div>
      </div>
      <div className="buttons">
        <button type="button" className="main" data-first onClick={() => dialog.current?.close()}>
          {t.stay}
        </button>
        <button type="button" className={loses ? "danger" : ""} onClick={leaveNow}>
          {leave}
        </button>
      </div>
    </dialog>
  );
}
