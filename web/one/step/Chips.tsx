// Texts to choose from: several of them, or one.

interface Props {
  readonly texts: readonly string[];
  readonly chosen: readonly string[];
  readonly disabled: boolean;
  readonly onChange: (text: string, isChosen: boolean) => void;
  /** One alone is chosen, of those that share this name. */
  readonly oneOf?: string;
}

export function Chips({ texts, chosen, disabled, onChange, oneOf }: Props) {
  if (texts.length === 0) return null;
  return (
    <div className="chips">
      {texts.map((text) => (
        <label key={text} className="chip">
          <input type={oneOf === undefined ? "checkbox" : "radio"} name={oneOf} disabled={disabled} checked={chosen.includes(text)} onChange={(event) => onChange(text, event.target.checked)} />
          <span>{text}</span>
        </label>
      ))}
    </div>
  );
}
