// The button and the dialog by which a phone is paired: it becomes a display, and moves the robot by hand.
import { useState } from "react";
import { PairDialog } from "../pairing/PairDialog";
import { api, useLogin, useRefusal } from "./client";
import { texts } from "./texts";

export function PairPhone() {
  const [isAsked, setAsked] = useState(false);
  const me = useLogin((login) => login.me);
  const refusal = useRefusal("pair");
  return (
    <>
      <button type="button" className="link pair" onClick={() => setAsked(true)}>
        {texts.frame.pair}
      </button>
      {isAsked && <PairDialog api={api} me={me} refusal={refusal} onClose={() => setAsked(false)} />}
    </>
  );
}
