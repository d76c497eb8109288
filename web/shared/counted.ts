// How many of something there are, in words: the one place that knows of one and several.

/** "1 step", "3 steps"; `several`: where that is not `one` with an s. */
export const counted = (count: number, one: string, several = `${one}s`): string => `${count} ${count === 1 ? one : several}`;
