// Why the last change was not made.
import { tell, useEditing } from "./editing";

export function Told() {
  const told = useEditing((now) => now.told);
  return (
    <div className="told" role="status" aria-label="What was said last">
      {told !== undefined && (
        <p className={told.isRefusal ? "is-refusal" : ""}>
          <span>{told.text}</span>
          <button type="button" className="plain" aria-label="Close this message" onClick={() => tell(undefined)}>
            ✕
          </button>
        </p>
      )}
    </div>
  );
}
