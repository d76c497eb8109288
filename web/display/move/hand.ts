// The robot, moved by hand by this page; a phone is felt where it is held.
import { createHand } from "../../control/hand";
import { api, fetchWithControls, ownControls, problem, rights, session } from "../client";
import { buzz } from "../signals";

export const hand = createHand({ api, session, rights, address: ownControls, fetcher: fetchWithControls, onProblem: problem, onRefused: () => buzz("refused"), onArrived: () => buzz("press") });
