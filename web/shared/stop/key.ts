// The key that stops the cell on every page, wherever the focus is (README.md: why this one).
export const kStopKey = "F3";

/** Whether a press means it; what is held besides does not count, and a held key is one press. */
export const isStopPress = ({ key, repeat }: Pick<KeyboardEvent, "key" | "repeat">): boolean => key === kStopKey && !repeat;
