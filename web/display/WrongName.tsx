// The name in the address is none of a display.
import { texts } from "./texts";

export function WrongName() {
  return <p className="notice is-bad">{texts.frame.wrongName}</p>;
}
