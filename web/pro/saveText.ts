// Saves a text, or what else a page has made, as a file of the user.

/** In this time the browser has read what it saves [ms]. */
const kReading = 10_000;

export const saveText = (name: string, type: string, text: string): void => saveBlob(name, new Blob([text], { type }));

export function saveBlob(name: string, content: Blob): void {
  const address = URL.createObjectURL(content);
  Object.assign(document.createElement("a"), { href: address, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(address), kReading);
}
