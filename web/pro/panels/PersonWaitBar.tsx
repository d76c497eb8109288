// The run waits for a person: what is asked, the answers, and the way to the page of a display; or that no display is there to ask on.
import { displayAddress, displayOf, displaysText, isAsking, ownDisplayFor, placeOf } from "../../shared/run/displayCalls";
import { textOn, type Unseen } from "../../shared/run/onDisplays";
import { askPairing } from "../pairing/pairing";
import { useRefusal } from "../login/rights";
import { AnswerHere } from "./AnswerHere";
import { Icon } from "./Icon";
import { becomeDisplay } from "./ownDisplay";
import { useQuestion, useUnseen } from "./question";

export function PersonWaitBar() {
  const wait = useQuestion();
  const unseen = useUnseen();
  if (wait === undefined) return unseen !== undefined && isAsking(unseen.call.operation) ? <NoDisplay unseen={unseen} /> : null;
  return (
    <div className="interruption person-wait" role="alert" aria-label="Waiting for a person">
      <Icon name="interrupted" />
      <div>
        <strong>Waiting for a person{wait.question === undefined ? "" : `: ${wait.question}`}</strong>
        <p>
          Asked by <code>{`svc.${wait.service}.${wait.operation}`}</code> on {displaysText(wait.display)}.{" "}
          <a href={displayAddress(wait.display)} target="_blank" rel="noreferrer">
            Open a display
          </a>
        </p>
      </div>
      {wait.answers !== undefined && <AnswerHere key={`${wait.service} ${wait.call}`} wait={wait} answers={wait.answers} />}
    </div>
  );
}

function NoDisplay({ unseen: { call, isHeard } }: { readonly unseen: Unseen }) {
  const display = displayOf(call);
  const question = textOn(call);
  const place = placeOf(display);
  const missing = place !== undefined ? `No display is connected at ${place}` : display === "all" ? "No display is connected" : `The display ${display} is not connected`;
  const refusal = useRefusal("be_display");
  return (
    <div className="interruption person-wait" role="alert" aria-label="Waiting for a display">
      <Icon name="interrupted" />
      <div>
        <strong>
          {isHeard ? `${missing}: nobody was asked` : "No display has taken the question"}
          {question === undefined ? "" : ` “${question}”`}
        </strong>
        <p>
          The call of <code>{`svc.${call.service}.${call.operation}`}</code> was answered by an error{isHeard ? "" : ", which nothing in the task reads: no display is connected, or its arguments are wrong"}. A task that asks again does
          so on the display that is there then.
        </p>
      </div>
      <div className="answers" role="group" aria-label="Ways to a display">
        <button type="button" disabled={refusal !== undefined} title={refusal ?? `This page becomes the display ${ownDisplayFor(display)}`} onClick={() => becomeDisplay(display)}>
          Answer on this page
        </button>
        <a href={displayAddress(display)} target="_blank" rel="noreferrer">
          Open a display
        </a>
        <button type="button" className="link" onClick={() => askPairing(true)}>
          Pair a phone
        </button>
      </div>
    </div>
  );
}
