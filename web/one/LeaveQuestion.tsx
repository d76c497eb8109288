// The question before an application is left whose edits the server has not taken.
import { useModal } from "../page/useModal";
import { useEditing } from "./editing";
import { leaveNow, stay, useIsLeaving } from "./leaving";
import { texts } from "./texts";

const t = texts.leave;

export function LeaveQuestion() {
  return useIsLeaving() ? <Question /> : null;
}

function Question() {
  const dialog = useModal();
  const edits = useEditing((now) => now.session?.pending.length ?? 0);
  const isSaved = edits === 0;
  return (
    <dialog ref={dialog} className="leaving" role="alertdialog" aria-labelledby="leaving-title" aria-describedby="leaving-means" onClose={stay}>
      <div role="status">
        <h2 id="leaving-title">{isSaved ? t.savedTitle : t.title(edits)}</h2>
        <p id="leaving-means">{isSaved ? t.saved : t.lost}</p>
      </div>
      <div className="buttons">
        <button type="button" className="main" data-first onClick={() => dialog.current?.close()}>
          {t.stay}
        </button>
        <button type="button" className={isSaved ? "" : "danger"} onClick={leaveNow}>
          {isSaved ? t.leave : t.giveUp}
        </button>
      </div>
    </dialog>
  );
}
