// The page's one connection: what the server shows goes into the page's state, what a person does goes to the server.
import { applyDisplayEvent, canAnswer, firstPage, type DisplayEvent, type DisplayPage } from "../shared/display/page";
import { schedule } from "../shared/display/sounds";
import { keyOf, type Key } from "../shared/display/numberText";
import type { Sound } from "../generated/messages";
import { openStream } from "../shared/stream";
import { createPlayer } from "./player";

/** What a person can do. */
export interface Actions {
  readonly answer: (question: number, answer: string | number) => void;
  readonly press: (button: string) => void;
  readonly key: (key: Key) => void;
}

/** Longer than a tap takes from the finger's lift to its click [ms]. */
const kTap = 400;

/** Runs for as long as the document lives; `draw` gets each new state. */
export function connect(name: string, draw: (page: DisplayPage, actions: Actions) => void): void {
  let page = firstPage(name);
  let playing: number | undefined;
  const player = createPlayer();

  const dispatch = (event: DisplayEvent) => {
    page = applyDisplayEvent(page, event);
    draw(page, actions);
  };

  const actions: Actions = {
    answer: (question, answer) => {
      if (canAnswer(page) && stream.say({ type: "answer", question, answer })) dispatch({ type: "sent" });
    },
    press: (button) => void stream.say({ type: "press", button }),
    key: (key) => dispatch({ type: "key", key }),
  };

  const scheme = location.protocol === "https:" ? "wss" : "ws";
  const stream = openStream(`${scheme}://${location.host}/api/v1/stream`, {
    onConnection: (connection) => dispatch({ type: "connection", connection }),
    onMalformed: (error) => dispatch({ type: "problem", text: error.message }),
    onNews: (news) => {
      if (news.type === "display") {
        dispatch({ type: "content", content: news.content });
        play(news.content.sound);
      } else if (news.type === "refused" && page.content === undefined) {
        dispatch({ type: "problem", text: news.errors.map((error) => error.message).join("; ") });
      }
    },
  });

  /** Each sound once; one that is taken away falls silent, one that comes before the first touch is not heard. */
  function play(sound: Sound | undefined): void {
    if (sound?.id === playing) return;
    playing = sound?.id;
    player.silence();
    if (sound === undefined || !page.sound) return;
    player.play(schedule(sound), sound.volume, () => stream.say({ type: "played", sound: sound.id }));
  }

  // Browsers make no sound before a person has touched the page. The hint goes when the tap is over: nothing moves under
  // the finger.
  const unlock = () => {
    void player.unlock().then(() => setTimeout(soundsAllowed, kTap));
  };
  function soundsAllowed(): void {
    if (page.sound) return;
    dispatch({ type: "sound" });
    stream.announce(name, true);
  }
  for (const touch of ["pointerup", "keydown"]) document.addEventListener(touch, unlock, { once: true });
  document.addEventListener("keydown", (event) => {
    const key = keyOf(event.key);
    if (key !== undefined && page.content?.question !== undefined && "number" in page.content.question) actions.key(key);
  });

  stream.announce(name, false);
  draw(page, actions);
}
