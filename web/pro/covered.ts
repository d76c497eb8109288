// What is over the page: its keys then act on nothing below.
import { isCovered } from "../shared/session/view";
import { view } from "./client";
import { areProposalsShown } from "./proposals/proposals";

export const isPageCovered = (): boolean => isCovered(view.get()) || areProposalsShown();
