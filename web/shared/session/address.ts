// The place of the page in its address: `?run=ID` of the run that is shown, `at=STEP.MICRO` of the moment of it, if that is past,
// `?edit=NAME` of the document that is edited, `page` where another is shown than that of the document or else of the run, `?runs=1` where the
// stored runs are listed, `proposals` if proposed changes are shown, all (`list`) or one, `versions` if the history of the document is shown, with what is compared (../versions/range.ts), `help` of the topic
// that is shown, `tour` of the document that the tour builds, `?follow=1` where the drawing of a run follows what becomes active,
// `axis=steps` if the time line counts macro steps; `in` of the state whose inside is drawn, `sel` of what is selected, `why` of its action or parameter that is asked about, `top` of the state of the
// library that is edited, `below` of what is shown below, where that is not what the window begins with (placeInAddress.ts).

export interface Place {
  readonly run?: string | undefined;
  readonly at?: string | undefined;
  readonly edit?: string | undefined;
  readonly runs?: string | undefined;
  readonly proposals?: string | undefined;
  readonly versions?: string | undefined;
  readonly help?: string | undefined;
  readonly tour?: string | undefined;
  readonly page?: string | undefined;
  readonly follow?: string | undefined;
  readonly axis?: string | undefined;
  readonly in?: string | undefined;
  readonly sel?: string | undefined;
  readonly why?: string | undefined;
  readonly top?: string | undefined;
  readonly below?: string | undefined;
}

/** What the query of an address says; an empty entry says nothing. */
export function placeOfAddress(search: string): Place {
  const query = new URLSearchParams(search);
  const entry = (key: keyof Place) => query.get(key) ?? undefined;
  return {
    run: entry("run"), at: entry("at"), edit: entry("edit"), runs: entry("runs"), proposals: entry("proposals"), versions: entry("versions"), help: entry("help"), tour: entry("tour"), page: entry("page"), follow: entry("follow"),
    axis: entry("axis"), in: entry("in"), sel: entry("sel"), why: entry("why"), top: entry("top"), below: entry("below"),
  };
}

/** The query with these entries; those that are undefined are taken out of it. */
export function addressWith(search: string, place: Place): string {
  const query = new URLSearchParams(search);
  for (const [key, value] of Object.entries(place) as readonly [keyof Place, string | undefined][]) {
    if (value === undefined) query.delete(key);
    else query.set(key, value);
  }
  // As paths are read.
  return `?${query.toString().replaceAll("%2F", "/")}`;
}
