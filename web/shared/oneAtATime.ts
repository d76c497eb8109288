// One request at a time: none is given up because something else is wanted meanwhile, which may change faster than the server answers.

/** The result asks for what is wanted now, and for nothing more with `undefined`. Of what is wanted while a request goes on, the last is asked for after it. */
export function oneAtATime<Wanted>(ask: (wanted: Wanted) => Promise<void>): (wanted: Wanted | undefined) => void {
  let busy = false;
  let next: Wanted | undefined;
  const begin = (wanted: Wanted): void => {
    busy = true;
    const end = () => {
      busy = false;
      const then = next;
      next = undefined;
      if (then !== undefined) begin(then);
    };
    ask(wanted).then(end, end);
  };
  return (wanted) => {
    if (busy) next = wanted;
    else if (wanted !== undefined) begin(wanted);
  };
}
