// Why the last change was not made.
import { tell, useEditing } from "./editing";
import { texts } from "./texts";

export function Told() {
  const told = useEditing((now) => now.told);
  return (
    <div className="told" role="status" aria-label={texts.frame.told}>
      {told !== undefined && (
        <p className={told.isRefusal ? "is-refusal" : ""}>
          <span>{told.text}</span>
          <button type="button" className="plain" aria-label={texts.frame.closeMessage} onClick={() => tell(undefined)}>
            ✕
          </button>
        </p>
      )}
    </div>
  );
}
