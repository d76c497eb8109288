// How the files of a test and of its model are called, so that `race test` finds the one by the other.

export const testFileOf = (document: string): string => `${document}.test.json`;
export const modelFileOf = (document: string): string => `${document}.rcm.json`;
