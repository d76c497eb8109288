// A sentence in which code stands in backquotes.
import { codePieces } from "../../shared/run/whyText";

export function CodeText({ text }: { readonly text: string }) {
  return codePieces(text).map((piece, i) => (piece.code ? <code key={i}>{piece.text}</code> : piece.text));
}
