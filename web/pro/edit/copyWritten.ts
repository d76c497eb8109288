// A text that somebody has written and the document has not, on the clipboard.
import { refuse, tellDone } from "./say";

/** The clipboard of the system is the page's over https or on this computer; else the text can be selected where it is shown. */
export function copyWritten(text: string): void {
  if (!isSecureContext) {
    refuse("the browser lets a page write the clipboard over https, or on this computer, only");
    return;
  }
  navigator.clipboard.writeText(text).then(
    () => tellDone("Copied."),
    () => refuse("the browser does not let the page write the clipboard"),
  );
}
