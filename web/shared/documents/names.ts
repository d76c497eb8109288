// Names of documents, and of the files that they come from and go to.

/** How long a name may be [character]. */
const kLongest = 64;
const kName = /^[A-Za-z0-9_-]+$/;

/** What a file of a document is called. */
export const fileOf = (name: string): string => `${name}.rcm.json`;

/** What a file of a bundle is called: a document with the interfaces of its services. */
export const bundleFileOf = (name: string): string => `${name}.bundle.json`;
export const isBundleFile = (file: string): boolean => /\.bundle( ?\(\d+\))?\.json$/i.test(file);

/** Why there can be no new document of this name, of those that are `taken`; nothing if there can. */
export function nameRefusal(name: string, taken: ReadonlySet<string>): string | undefined {
  if (name === "") return "A document needs a name.";
  if (name.length > kLongest) return `A name has at most ${kLongest} characters.`;
  if (!kName.test(name)) return "A name is made of A-Z, a-z, 0-9, _ and -.";
  return taken.has(name) ? `There is a document ${name}.` : undefined;
}

/** `wish`, or with the first number from 2 on that makes it a name that is not taken. */
export function freeDocumentName(wish: string, taken: ReadonlySet<string>): string {
  let name = wish;
  for (let i = 2; taken.has(name); ++i) name = `${wish.slice(0, kLongest - 1 - String(i).length)}-${i}`;
  return name;
}

/** The name that a file suggests: that of the file, without what a name cannot have. */
export function nameOfFile(file: string): string {
  const plain = file.replace(/(\.rcm|\.bundle)?\.json$/i, "").replace(/[^A-Za-z0-9_-]+/g, "_").slice(0, kLongest);
  return plain === "" ? "document" : plain;
}

/** A state of the same name, as far as a state can have it: it has neither `-` nor a digit at the beginning. */
const stateOf = (name: string): string => name.replaceAll("-", "_").replace(/^\d/, "_$&");

/** The text of a new document: a root state without anything, which can be run. */
export const newDocumentText = (name: string): string => JSON.stringify({ rcm: 1, root: { state: stateOf(name) } });
