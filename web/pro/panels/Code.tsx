// A function of a state, whole, with the condition of an action above it.
interface Props {
  readonly title: string;
  readonly code: string;
  readonly condition?: string;
}

export function Code({ title, code, condition }: Props) {
  return (
    <section aria-label={title}>
      <h3>{title}</h3>
      {condition !== undefined && (
        <p className="when">
          when <code>{condition}</code>
        </p>
      )}
      <pre className="code">
        <code>{code.trimEnd()}</code>
      </pre>
    </section>
  );
}
