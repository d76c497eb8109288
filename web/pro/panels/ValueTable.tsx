// Names with their live values; a name without a value is dimmed.
import { Fragment } from "react";
import type { Proposal } from "../../shared/debugger/force";
import type { JsonValue } from "../../shared/json";
import { valueText } from "../../shared/model/describe";
import { isSameAsked } from "../../shared/run/subject";
import { useView } from "../client";
import { ForceValue } from "../debugger/ForceValue";
import { WhyAnswer, WhyButton } from "./WhyOf";

interface Props {
  readonly title: string;
  readonly names: readonly string[];
  readonly values: Readonly<Record<string, JsonValue>> | undefined;
  /** Notes of the model on a name: a source expression, a unit. */
  readonly notes?: Readonly<Record<string, string>>;
  /** Of which state they are, and what: they can be forced. */
  readonly forced?: Pick<Proposal, "path" | "scope">;
  /** The parameters of which state they are, so that people can ask where each value comes from. */
  readonly parametersOf?: string;
}

export function ValueTable({ title, names, values, notes, forced, parametersOf }: Props) {
  const all = [...new Set([...names, ...Object.keys(values ?? {})])];
  if (all.length === 0) return null;
  return (
    <section aria-label={title}>
      <h3>{title}</h3>
      <table className="values">
        <tbody>
          {all.map((name) => {
            const value = values?.[name];
            return (
              <Fragment key={name}>
              <tr>
                <th scope="row">
                  {name}
                  {notes?.[name] !== undefined && <small>{notes[name]}</small>}
                </th>
                <td className={value === undefined ? "unset" : ""}>
                  {forced !== undefined && <ForceValue {...forced} name={name} value={value} />}
                  <code>{value === undefined ? "no value yet" : valueText(value)}</code>
                  {parametersOf !== undefined && <WhyButton asked={{ parameter: name }} name={`${name} has its value`} />}
                </td>
              </tr>
              {parametersOf !== undefined && <WhyRow path={parametersOf} name={name} />}
              </Fragment>
            );
          })}
        </tbody>
      </table>
    </section>
  );
}

/** The answer where a value comes from, below its row. */
function WhyRow({ path, name }: { readonly path: string; readonly name: string }) {
  const isOpen = useView((v) => isSameAsked(v.asked, { parameter: name }));
  if (!isOpen) return null;
  return (
    <tr>
      <td colSpan={2}>
        <WhyAnswer path={path} asked={{ parameter: name }} />
      </td>
    </tr>
  );
}
