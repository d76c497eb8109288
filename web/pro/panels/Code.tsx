// A function of a state, whole, with the condition of an action above it.
import type { ReactNode } from "react";

interface Props {
  readonly title: string;
  readonly code: string;
  readonly condition?: string;
  /** Beside its title. */
  readonly children?: ReactNode;
}

export function Code({ title, code, condition, children }: Props) {
  return (
    <section aria-label={title}>
      <h3>
        {title}
        {children}
      </h3>
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
