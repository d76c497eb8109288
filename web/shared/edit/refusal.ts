// Why an edit is not applied.

/** Codes of the server (core/edit) that a client can find by itself. */
export type RefusalCode = "constant" | "duplicate" | "missing" | "not_accepted" | "not_found" | "oracle" | "too_deep" | "type" | "unknown_field" | "version";

export class Refusal extends Error {
  constructor(
    readonly code: RefusalCode,
    message: string,
    /** The field of the operation, or of the edit (`operations/0/after`). */
    readonly path = "",
  ) {
    super(message);
    this.name = "Refusal";
  }

  /** The same, further out. */
  at(path: string): Refusal {
    return new Refusal(this.code, this.message, path);
  }
}

/** What `make` returns, or the refusal that it throws. */
export function attempt<T>(make: () => T): T | Refusal {
  try {
    return make();
  } catch (error) {
    if (error instanceof Refusal) return error;
    throw error;
  }
}
