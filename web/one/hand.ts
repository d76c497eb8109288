// The robot, moved by hand by this page, and the poses that were taught.
import { createHand } from "../control/hand";
import { api, fetcher, ownControls, problem, rights, session } from "./client";

export const hand = createHand({ api, session, rights, address: ownControls, fetcher, onProblem: problem });
