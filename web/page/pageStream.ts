// The connection of a page to the server, and what every page does with it: who uses it, what is told of runs, what is in the way.
import { createSpeedWatch, kNoSpeed, type SpeedState } from "../shared/control/speed";
import type { Access } from "../shared/login/access";
import { refusalTo } from "../shared/login/doings";
import { messageOf } from "../shared/messageOf";
import type { StreamUpdate } from "../shared/messages/stream";
import { watchReach } from "../shared/reach";
import type { Session, SessionEvent } from "../shared/session/session";
import type { Told } from "../shared/slowly";
import type { Store } from "../shared/store";
import { openStream, type Connection, type Stream, type StreamHandlers } from "../shared/stream";
import { controls, every } from "../control/page";
import { stop } from "../stop/page";
import { createAccount } from "./account";
import { createStore, useSelected } from "./store";

/** A part of the page with channels or requests of its own. */
export interface StreamListener {
  readonly update: (update: StreamUpdate) => void;
  readonly connection: (connection: Connection) => void;
}

export interface PageStreamOptions {
  /** Of the page as a whole. */
  readonly channels: readonly string[];
  /** Takes up what is not of the session; false: it is of the session. Who has the controls is neither. */
  readonly take: (update: StreamUpdate) => boolean;
  /** The session has it. */
  readonly onTaken: (update: StreamUpdate) => void;
  readonly onConnection?: (connection: Connection) => void;
  /** Otherwise it is shown as a problem. */
  readonly onMalformed?: StreamHandlers["onMalformed"];
}

/** How fast the robot goes on its way. */
export interface RobotSpeed {
  readonly store: Told<SpeedState>;
  /** This page has set it: 0..1. */
  readonly told: (share: number) => void;
}

/** To be called once by a page. */
export function createPageStream(session: Store<Session, SessionEvent>) {
  let stream: Stream | undefined;
  const account = createAccount(() => stream?.reopen());
  const { access, api, bystander, login, ownStream } = account;
  const listeners = new Set<StreamListener>();

  /** Shows what is in the way until somebody has read it. */
  const problem = (error: unknown): void => session.dispatch({ type: "problem", text: messageOf(error) });

  const speed = createStore<SpeedState, SpeedState>(kNoSpeed, (_, next) => next);
  const speedWatch = createSpeedWatch({
    ask: (robot) => bystander.callService(robot, "state", {}),
    services: () => session.get().services,
    refusal: () => refusalTo(login.get().me, "call_service"),
    after: (time, act) => void setTimeout(act, time),
    onChange: speed.dispatch,
  });

  function connect({ channels, take, onTaken, onConnection, onMalformed = problem }: PageStreamOptions): Stream {
    const opened = openStream(ownStream, {
      onConnection: (connection, ended) => {
        if (connection !== "connecting" && !access.get().asked) void access.ask().catch(() => undefined); // the account may have changed
        session.dispatch({ type: "connection", connection, ended });
        stop.connection(connection);
        if (connection === "lost") speedWatch.forget();
        listeners.forEach((listener) => listener.connection(connection));
        onConnection?.(connection);
      },
      onMalformed,
      onUpdate: (update) => {
        reach.heard();
        if (update.type === "control") stop.take(update.control);
        else if (!take(update)) session.dispatchInFrame((frame) => ({ type: "update", update, frame }));
        speedWatch.receive(update);
        onTaken(update);
        listeners.forEach((listener) => listener.update(update));
      },
    });
    stream = opened;
    const reach = watchReach({
      fetcher: (input, init) => fetch(input, init),
      now: () => Date.now(),
      every,
      timeout: (time) => AbortSignal.timeout(time),
      isSeen: () => !document.hidden,
      isOpen: () => session.get().connection === "open",
      onLost: () => {
        // What is moved by hand ends with them: the server may not hear that a button is released.
        controls.release("the server does not answer");
        opened.abandon();
      },
      onBack: () => opened.retry(),
    });
    for (const channel of channels) opened.subscribe(channel);
    return opened;
  }

  function listenToStream(listener: StreamListener): { readonly stream: Stream; readonly end: () => void } {
    if (stream === undefined) throw new Error("the page is not connected");
    listeners.add(listener);
    return { stream, end: () => listeners.delete(listener) };
  }

  async function attempt(action: () => Promise<unknown>): Promise<void> {
    try {
      await action();
    } catch (error) {
      problem(error);
    }
  }

  async function logIn(name: string, password: string): Promise<void> {
    await access.logIn(name, password);
    stream?.retry();
  }

  async function loadDocuments(): Promise<void> {
    try {
      session.dispatch({ type: "documents", documents: await api.documents() });
    } catch (error) {
      if (session.get().connection !== "lost") problem(error);
    }
  }

  return {
    ...account,
    useLogin: <T>(select: (access: Access) => T): T => useSelected(login, select),
    /** Nothing before `connect`. */
    stream: (): Stream | undefined => stream,
    /** To be called once; the connection stays until the page is closed. */
    connect,
    /** The page's connection, and from now on all that comes over it; the result ends that. Requires `connect`. */
    listenToStream,
    problem,
    dismissProblem: (): void => session.dispatch({ type: "problem", text: undefined }),
    /** Does something, and shows why it has failed. */
    attempt,
    /** Also connects at once. */
    logIn,
    /** Loads the list of documents, which no channel tells of. */
    loadDocuments,
    robotSpeed: { store: speed, told: speedWatch.told } satisfies RobotSpeed,
  };
}
