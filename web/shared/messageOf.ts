// What an error that was caught says, for people.

export const messageOf = (error: unknown): string => (error instanceof Error ? error.message : String(error));
