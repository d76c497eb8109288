// The controls of the cell, as this page has them.
import { useSyncExternalStore } from "react";
import { createControlLink, type ControlSocket, type LinkState, type SocketHandlers } from "../shared/control/link";
import { stop } from "../stop/page";
import { texts } from "./texts";

function open(address: string, { onOpen, onText, onClose }: SocketHandlers): ControlSocket {
  const socket = new WebSocket(address);
  socket.onopen = onOpen;
  socket.onclose = onClose;
  socket.onmessage = ({ data }: MessageEvent<unknown>) => onText(String(data));
  return { send: (text) => socket.readyState === WebSocket.OPEN && socket.send(text), close: () => socket.close() };
}

export function every(time: number, act: () => void): () => void {
  const timer = setInterval(act, time);
  return () => clearInterval(timer);
}

const listeners = new Set<() => void>();

export const controls = createControlLink({
  open,
  // Goes on while the device sleeps.
  now: () => Date.now(),
  every,
  onChange: (state) => {
    stop.hold(state.kind === "held" ? state.number : undefined);
    listeners.forEach((listener) => listener());
  },
});

export function listenToControls(listener: () => void): () => void {
  listeners.add(listener);
  return () => listeners.delete(listener);
}

export const useControls = <T>(select: (state: LinkState) => T): T => useSyncExternalStore(listenToControls, () => select(controls.get()));

/** Gives the controls back when nobody can see what happens; to be called once. */
export function followControls(): void {
  document.addEventListener("visibilitychange", () => document.hidden && controls.release(texts.take.hidden));
  document.addEventListener("freeze", () => controls.release(texts.take.frozen));
  addEventListener("pagehide", () => controls.release(texts.take.left));
}
