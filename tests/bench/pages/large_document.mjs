// A document of about 2000 states with stored layout, for measurements: ten groups that run at the same time, in each a ring of twenty
// composites, in each of them a chain of nine states that go on after a moment.

const kGroups = 10;
const kRing = 20;
const kChain = 9;
/** Distances of neighbours, and how many stand in a row: of states, composites and groups [px]. */
const kPlaces = { state: { x: 210, y: 86, row: 3 }, composite: { x: 740, y: 400, row: 5 }, group: { x: 3900, y: 1780, row: 3 } };

const placeOf = ({ x, y, row }, i) => ({ x: 10 + (i % row) * x, y: 10 + Math.floor(i / row) * y });

const numbered = (count, make) => Array.from({ length: count }, (_, i) => make(i));

function chainState(id, i, seconds, layout) {
  layout[id] = placeOf(kPlaces.state, i);
  const last = i === kChain - 1;
  return { state: `Step${i + 1}`, meta: { id }, ports: [{ name: "done", after: String(seconds), ...(!last && { to: `Step${i + 2}` }), meta: { id: `${id}-done` } }] };
}

function composite(id, i, seconds, layout) {
  layout[id] = placeOf(kPlaces.composite, i);
  const port = { name: "next", when: `chi.Step${kChain}.port.done`, to: `Part${((i + 1) % kRing) + 1}`, meta: { id: `${id}-next` } };
  return { state: `Part${i + 1}`, first: "Step1", meta: { id }, children: numbered(kChain, (k) => chainState(`${id}-${k}`, k, seconds, layout)), ports: [port] };
}

function group(g, seconds, layout) {
  const id = `g${g}`;
  layout[id] = placeOf(kPlaces.group, g + 1);
  return { state: `Group${g + 1}`, first: "Part1", meta: { id }, children: numbered(kRing, (i) => composite(`${id}-${i}`, i, seconds, layout)) };
}

/** `changes`: so many states are entered in a second while it runs. */
export function largeDocument(changes) {
  const layout = { all: { x: 40, y: 40 } };
  const groups = numbered(kGroups, (g) => group(g, kGroups / changes, layout));
  const all = { barrier: "All", to: groups.map(({ state }) => state), meta: { id: "all" } };
  return { rcm: 1, name: "large", root: { state: "Large", first: "All", children: [all, ...groups], meta: { id: "root" } }, layout };
}
