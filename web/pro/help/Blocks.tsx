// What a topic of the help is made of.
import { assertNever } from "../../shared/assertNever";
import type { Block } from "../../shared/help/blocks";
import { LegendLists } from "../canvas/legend/LegendLists";
import { CodeText } from "../panels/CodeText";
import { KeyLists } from "../panels/KeyHelp";
import { Figure } from "./Figure";

interface Props {
  readonly blocks: readonly Block[];
  /** Id of a term that is pointed out. */
  readonly marked: string | undefined;
}

export function Blocks({ blocks, marked }: Props) {
  return blocks.map((block, i) => <One key={i} block={block} marked={marked} />);
}

function One({ block, marked }: { readonly block: Block; readonly marked: string | undefined }) {
  switch (block.kind) {
    case "text":
      return (
        <p>
          <CodeText text={block.text} />
        </p>
      );
    case "heading":
      return <h3>{block.text}</h3>;
    case "code":
      return <pre>{block.text}</pre>;
    case "list":
      return (
        <ul>
          {block.items.map((item) => (
            <li key={item}>
              <CodeText text={item} />
            </li>
          ))}
        </ul>
      );
    case "terms":
      return (
        <dl className="help-terms">
          {block.terms.map(({ name, text, id }) => (
            <div key={name} id={id} className={id !== undefined && id === marked ? "is-marked" : undefined}>
              <dt>
                <code>{name}</code>
              </dt>
              <dd>
                <CodeText text={text} />
              </dd>
            </div>
          ))}
        </dl>
      );
    case "figure":
      return <Figure example={block.example} caption={block.caption} />;
    case "legend":
      return <LegendLists groups={block.groups} />;
    case "keys":
      return <KeyLists />;
    default:
      return assertNever(block);
  }
}
