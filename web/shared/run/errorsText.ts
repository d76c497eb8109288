/** "1 error", "3 errors". */
export const errorsText = (count: number): string => `${count} ${count === 1 ? "error" : "errors"}`;
