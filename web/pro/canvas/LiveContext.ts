// The run's light for the nodes and lines of the canvas, and the zoom band that decides how large they write.
import { createContext, useContext } from "react";
import { still, type Live } from "../../shared/drawing/live";

export const LiveContext = createContext<Live>(still);
export const useLive = (): Live => useContext(LiveContext);
