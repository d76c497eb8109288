// The page forbids style elements (Content-Security-Policy), which CodeMirror would make: its styles go into a sheet that the document adopts.
import { StyleModule } from "style-mod";

/** Once, before the first editor: styles of the document are kept where those of a shadow root would be. */
export function adoptStyles(): void {
  const root = {
    ownerDocument: document,
    get adoptedStyleSheets() {
      return document.adoptedStyleSheets;
    },
    set adoptedStyleSheets(sheets) {
      document.adoptedStyleSheets = sheets;
    },
  };
  StyleModule.mount(root as unknown as ShadowRoot, []);
  for (const key of Object.getOwnPropertySymbols(root)) Reflect.set(document, key, Reflect.get(root, key));
}
