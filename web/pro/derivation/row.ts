// Sizes that the lists of proofs and their style (styles/derivation.css) agree on.

/** Height of a row [px]. */
export const kRow = 22;

/** Width of a level of the tree [px]. */
export const kLevel = 20;
