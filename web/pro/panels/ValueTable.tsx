// Names with their live values; a name without a value is dimmed.
import type { JsonValue } from "../../shared/json";
import { valueText } from "../../shared/model/describe";

interface Props {
  readonly title: string;
  readonly names: readonly string[];
  readonly values: Readonly<Record<string, JsonValue>> | undefined;
  /** Notes of the model on a name: a source expression, a unit. */
  readonly notes?: Readonly<Record<string, string>>;
}

export function ValueTable({ title, names, values, notes }: Props) {
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
