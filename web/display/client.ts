// The page's one connection: messages of the server change the page's state, actions of the user are sent to the server.
import { applyDisplayEvent, canAnswer, firstPage, type DisplayEvent, type DisplayPage } from "../shared/display/page";
import { schedule } from "../shared/display/sounds";
import { keyOf, type Key } from "../shared/display/numberText";
import type { Sound } from "../generated/messages";
import { createAccess } from "../shared/login/access";
import { controlUrl } from "../shared/control/link";
import { refusalTo, type Doing } from "../shared/login/doings";
import { storedTokens } from "../shared/login/tokens";
import { stop } from "../stop/page";
import { openStream, streamUrl } from "../shared/stream";
import { createPlayer } from "./player";

/** What the user can do. */
export interface Actions {
  /** Why the stop cannot be reset here. */
  readonly resetRefusal: string | undefined;
  /** Why the controls of the cell cannot be taken here, and who asks for them cannot be answered. */
  readonly takeRefusal: string | undefined;
  readonly answerRefusal: string | undefined;
  /** The address of the controls. */
  readonly controls: () => Promise<string>;
  /** Of the account. */
  readonly fetcher: typeof fetch;
  readonly answer: (question: number, answer: string | number) => void;
  readonly press: (button: string) => void;
  readonly key: (key: Key) => void;
}

/** Longer than the delay between the end of a touch and its click event [ms]. */
const kTap = 400;

/** Runs until the page is closed, as a display of this name, at this place; `draw` gets each new state, and `drawLogin` what logs in while the server asks for that. */
export function connect(name: string, place: string | undefined, draw: (page: DisplayPage, actions: Actions) => void, drawLogin: (logIn: (name: string, password: string) => Promise<void>) => void): void {
  let page = firstPage(name);
  let playing: number | undefined;
  const player = createPlayer();

  const show = () => {
    const { me, asked } = access.get();
    const refusal = refusalTo(me, "be_display");
    const refused = (doing: Doing) => (page.connection === "open" ? refusalTo(me, doing) : "the server is not there");
    if (asked) drawLogin(logIn);
    else draw(refusal === undefined ? page : { ...page, problem: `This page is no display: ${refusal}.` }, { ...actions, resetRefusal: refused("reset_stop"), takeRefusal: refused("take_controls"), answerRefusal: refused("answer_control") });
  };
  const dispatch = (event: DisplayEvent) => {
    page = applyDisplayEvent(page, event);
    show();
  };
  const access = createAccess({ base: "/api/v1", fetcher: (input, init) => fetch(input, init), tokens: storedTokens(() => localStorage, window), onChange: () => show(), onOtherLogin: () => stream.reopen() });
  async function logIn(account: string, password: string): Promise<void> {
    await access.logIn(account, password);
    stream.retry();
  }

  const actions: Omit<Actions, "resetRefusal" | "takeRefusal" | "answerRefusal"> = {
    controls: () => access.streamUrl(controlUrl(location)),
    fetcher: access.fetch,
    answer: (question, answer) => {
      if (canAnswer(page) && stream.send({ type: "answer", question, answer })) dispatch({ type: "sent" });
    },
    press: (button) => void stream.send({ type: "press", button }),
    key: (key) => dispatch({ type: "key", key }),
  };

  const stream = openStream(() => access.streamUrl(streamUrl(location)), {
    onConnection: (connection) => {
      if (connection === "lost" && !access.get().asked) void access.ask().catch(() => undefined); // the account may have changed
      stop.connection(connection);
      dispatch({ type: "connection", connection });
    },
    onMalformed: (error) => dispatch({ type: "problem", text: error.message }),
    onUpdate: (update) => {
      if (update.type === "display") {
        dispatch({ type: "content", content: update.content });
        play(update.content.sound);
      } else if (update.type === "control") stop.take(update.control);
      else if (update.type === "refused" && page.content === undefined) {
        dispatch({ type: "problem", text: update.errors.map((error) => error.message).join("; ") });
      }
    },
  });

  /** Plays each sound once. A sound that the server removes is stopped; one before the first touch is not played. */
  function play(sound: Sound | undefined): void {
    if (sound?.id === playing) return;
    playing = sound?.id;
    player.silence();
    if (sound === undefined || !page.sound) return;
    player.play(schedule(sound), sound.volume, () => stream.send({ type: "played", sound: sound.id }));
  }

  // Browsers play no sound before the first touch. The hint is removed after the tap, so that nothing moves under
  // the finger.
  const unlock = () => {
    void player.unlock().then(() => setTimeout(soundsAllowed, kTap));
  };
  function soundsAllowed(): void {
    if (page.sound) return;
    dispatch({ type: "sound" });
    stream.announceDisplay(name, true, place);
  }
  for (const touch of ["pointerup", "keydown"]) document.addEventListener(touch, unlock, { once: true });
  document.addEventListener("keydown", (event) => {
    const key = keyOf(event.key);
    if (key !== undefined && page.content?.question !== undefined && "number" in page.content.question) actions.key(key);
  });

  stream.announceDisplay(name, false, place);
  stream.subscribe("control");
  show();
}
