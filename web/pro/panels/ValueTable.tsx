// Names with their live values; a name without a value is dimmed.
import type { Proposal } from "../../shared/debugger/force";
import type { JsonValue } from "../../shared/json";
import { valueText } from "../../shared/model/describe";
import { ForceValue } from "../debugger/ForceValue";

interface Props {
  readonly title: string;
  readonly names: readonly string[];
  readonly values: Readonly<Record<string, JsonValue>> | undefined;
  /** Notes of the model on a name: a source expression, a unit. */
  readonly notes?: Readonly<Record<string, string>>;
  /** Of which state they are, and what: they can be forced. */
  readonly forced?: Pick<Proposal, "path" | "scope">;
}

export function ValueTable({ title, names, values, notes, forced }: Props) {
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
              <tr key={name}>
                <th scope="row">
                  {name}
                  {notes?.[name] !== undefined && <small>{notes[name]}</small>}
                </th>
                <td className={value === undefined ? "unset" : ""}>
                  {forced !== undefined && <ForceValue {...forced} name={name} value={value} />}
                  <code>{value === undefined ? "no value yet" : valueText(value)}</code>
                </td>
              </tr>
            );
          })}
        </tbody>
      </table>
    </section>
  );
}
