// Saves a text as a file of the user.

/** In this time the browser has read what it saves [ms]. */
const kReading = 10_000;

export function saveText(name: string, type: string, text: string): void {
  const address = URL.createObjectURL(new Blob([text], { type }));
  Object.assign(document.createElement("a"), { href: address, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(address), kReading);
}
