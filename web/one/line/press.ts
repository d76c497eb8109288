// Whether a press on a card was a drag: then the click that ends it is none. Any other click is one, by a finger and by a key, too.

export interface PressEvent {
  readonly pointerType: string;
  readonly button: number;
  readonly preventDefault: () => void;
}

export interface PressHandlers<E extends PressEvent> {
  readonly fromCard: (event: E) => void;
  readonly fromGrip: (event: E) => void;
  /** Of a click on the card: not of one that ends a drag. */
  readonly isClick: (click: { readonly detail: number }) => boolean;
}

/** Of the last press on a card, kept over its drawings. */
export interface LastPress {
  readonly wasDrag: () => boolean;
  readonly note: (wasDrag: boolean) => void;
}

export function createLastPress(): LastPress {
  let drag = false;
  return { wasDrag: () => drag, note: (was) => void (drag = was) };
}

/** `follow` says at the end of a press whether it was a drag. */
export function pressHandlers<E extends PressEvent>(last: LastPress, follow: (event: E, onEnd: (was: boolean) => void) => void): PressHandlers<E> {
  return {
    fromCard: (event) => {
      last.note(false);
      // A finger on a card scrolls.
      if (event.pointerType === "mouse" && event.button === 0) follow(event, last.note);
    },
    // The grip stands beside the card: no click on the card ends a press there.
    fromGrip: (event) => {
      event.preventDefault();
      if (event.button === 0) follow(event, () => undefined);
    },
    // A key gives a click without a press.
    isClick: ({ detail }) => detail === 0 || !last.wasDrag(),
  };
}
