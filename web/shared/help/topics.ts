// All topics of the help, in order, and their search.
import { assertNever } from "../assertNever";
import { accounts } from "./accounts";
import { groups, text, type Block, type Topic } from "./blocks";
import { concepts } from "./concepts";
import { errorTopics } from "./errorCodes";
import { language } from "./language";
import { cellLegend, drawingLegend } from "./legend";
import { running } from "./running";

const first: Topic = {
  id: "start", title: "What RACE is", group: "First steps",
  blocks: [
    text("A task is drawn as states, which coordinate services: robots, grippers, cameras, displays. The server executes it by exact rules, and shows for each step why it happened. You can change a task while it runs, alone or with others."),
    { kind: "list", items: ["Task: the run that is watched, with all its values.", "Edit: a document is drawn and changed; each edit is stored at once.", "Services: what robots and devices can do now.", "Cell: the robot and its surroundings in 3D."] },
    text("The tour builds and runs a first task with you, in about five minutes. Nothing moves in it."),
  ],
};

const signs: Topic = {
  id: "signs", title: "Legend: signs of the drawing and of the cell", group: "Reference",
  blocks: [text("Legend beside the drawing shows the same there."), { kind: "legend", groups: [...drawingLegend, ...cellLegend] }],
};

const keys: Topic = { id: "keys", title: "Keys and mouse", group: "Reference", blocks: [{ kind: "keys" }] };

export const topics: readonly Topic[] = [first, ...concepts, ...running, ...language, ...accounts, ...errorTopics, signs, keys];

export const topicOf = (id: string): Topic | undefined => topics.find((topic) => topic.id === id);

/** The topics by their groups, in order. */
export const groupedTopics = (all: readonly Topic[]): readonly { readonly group: string; readonly topics: readonly Topic[] }[] =>
  groups.map((group) => ({ group, topics: all.filter((topic) => topic.group === group) })).filter((each) => each.topics.length > 0);

function wordsOf(block: Block): string {
  switch (block.kind) {
    case "text":
    case "code":
    case "heading":
      return block.text;
    case "list":
      return block.items.join("\n");
    case "terms":
      return block.terms.map(({ name, text: words }) => `${name} ${words}`).join("\n");
    case "figure":
      return block.caption;
    case "legend":
      return block.groups.flatMap(({ title, entries }) => [title, ...entries.map((entry) => entry.text)]).join("\n");
    case "keys":
      return "";
    default:
      return assertNever(block);
  }
}

/** The topics that have all words of the query, those with them in the title first. */
export function findTopics(query: string): readonly Topic[] {
  const wanted = query.toLowerCase().split(/\s+/).filter((word) => word !== "");
  if (wanted.length === 0) return topics;
  const has = (words: string) => wanted.every((word) => words.toLowerCase().includes(word));
  const inTitle = topics.filter(({ title }) => has(title));
  return [...inTitle, ...topics.filter((topic) => !inTitle.includes(topic) && has([topic.title, ...topic.blocks.map(wordsOf)].join("\n")))];
}
