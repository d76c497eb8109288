// Left of the drawing: the coverage of tests that was opened, how much there is of it, and what no test has come to.
import { useEffect, useRef, type KeyboardEvent } from "react";
import { FileButton } from "../../page/FileButton";
import { documentOfModel } from "../../shared/coverage/report";
import { countText, kKindNames, otherText, reportText } from "../../shared/coverage/texts";
import { useView } from "../client";
import { useEditing } from "../edit/editing";
import { chooseModel, kMostDrawn, openCoverage, showCoverage, useCoverage, useDrawnCoverage, useOpened, type ShownCoverage } from "./coverage";
import { kSigns } from "./CoverageMarks";
import { GapList } from "./GapList";

const kKinds = ["states", "ports", "conditions"] as const;

function press(event: KeyboardEvent<HTMLElement>): void {
  if (event.key !== "Escape") return;
  showCoverage(false);
  event.preventDefault();
  event.stopPropagation();
}

export function CoveragePanel() {
  const heading = useRef<HTMLHeadingElement>(null);
  const page = useView((v) => v.page);
  const reason = useOpened((opened) => opened.reason);
  const report = useOpened((opened) => opened.report);
  const coverage = useCoverage();
  useEffect(() => heading.current?.focus({ preventScroll: true }), []);
  if (page !== "edit") return null;
  return (
    <section className="coverage" aria-label="Coverage" onKeyDown={press}>
      <header>
        <h2 ref={heading} tabIndex={-1}>
          Coverage
        </h2>
        <button type="button" aria-label="Close the coverage" title="Close (Esc)" onClick={() => showCoverage(false)}>
          ✕
        </button>
      </header>
      {report === undefined && (
        <p className="quiet pad">
          What no test comes to. <code>race test --coverage --json FILE &gt; coverage.json</code> writes the file; open it here, or drop it on the page.
        </p>
      )}
      <OpenFile />
      {reason !== undefined && (
        <p className="bad pad" role="alert">
          {reason}
        </p>
      )}
      {coverage !== undefined && <Shown coverage={coverage} />}
    </section>
  );
}

function OpenFile() {
  return (
    <div className="coverage-open">
      <FileButton
        name="File with the coverage of tests"
        onFiles={([file]) => {
          if (file !== undefined) void openCoverage(file);
        }}
      >
        Open a file…
      </FileButton>
    </div>
  );
}

function Shown({ coverage }: { readonly coverage: ShownCoverage }) {
  const { report, model, counts, gaps, unknown, untold } = coverage;
  const document = useEditing((now) => now.document);
  const drawn = useDrawnCoverage();
  const models = Object.keys(report.models);
  const other = otherText(model, documentOfModel(model), document, unknown, untold);
  return (
    <>
      <p className="pad" role="status" aria-label="Coverage file">
        {reportText(report)}
      </p>
      {models.length > 1 && (
        <label className="coverage-model">
          <span>Model</span>
          <select value={model} onChange={({ target }) => chooseModel(target.value)}>
            {models.map((name) => (
              <option key={name}>{name}</option>
            ))}
          </select>
        </label>
      )}
      {other !== undefined && (
        <p className="coverage-other" role="note">
          {other}
        </p>
      )}
      <dl className="coverage-counts">
        {kKinds.map((kind) => (
          <div key={kind}>
            <dt>{kKindNames[kind]}</dt>
            <dd>{countText(counts[kind])}</dd>
          </div>
        ))}
      </dl>
      <ul className="coverage-signs" aria-label="Signs in the drawing">
        <li>
          <span className="coverage-sign is-never" aria-hidden="true">{kSigns.never}</span> never active, or never fired
        </li>
        <li>
          <span className="coverage-sign is-partly" aria-hidden="true">{kSigns.partly}</span> conditions, or what is in it, in part
        </li>
      </ul>
      {drawn.length > kMostDrawn && <p className="quiet pad">The drawing has the first {kMostDrawn} signs of {drawn.length}: enter a state to see its own.</p>}
      {gaps.length === 0 ? <p className="quiet pad">Nothing is missing.</p> : kKinds.map((kind) => <GapList key={kind} kind={kind} gaps={gaps.filter((gap) => gap.kind === kind)} />)}
    </>
  );
}
