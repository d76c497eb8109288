// The path of the shown state in the hierarchy; a click on a part goes up to it.
import { ancestry, nameOf, type ModelTree } from "../../shared/model/modelTree";
import { useView, view } from "../client";

export function Breadcrumb({ tree }: { readonly tree: ModelTree }) {
  const focus = useView((v) => v.focus);
  const root = tree.keys().next().value ?? "";
  const parts = ancestry(focus !== undefined && tree.has(focus) ? focus : root);
  return (
    <nav className="breadcrumb" aria-label="Breadcrumb">
      <ol>
        {parts.map((path, i) => (
          <li key={path}>
            <button
              type="button"
              aria-current={i === parts.length - 1 ? "location" : undefined}
              onClick={() => view.dispatch({ type: "enter", path: i === 0 ? undefined : path })}
            >
              {nameOf(path)}
            </button>
          </li>
        ))}
      </ol>
    </nav>
  );
}
