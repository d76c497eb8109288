// The author of the edits of this page: the name of its person, with a tag that no other page has. The server keeps undo by the author, so
// two people of one name, and two pages of one person, each take back their own edits.
import { authorOf } from "../../shared/presence/names";
import { ownName } from "../presence/ownName";
import { pageTag } from "./pageTag";

export const author = (): string => authorOf(ownName(), pageTag);
