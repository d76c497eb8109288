/** A document of about 2000 states with stored layout; `changes`: so many states are entered in a second while it runs. */
export function largeDocument(changes: number): object;
