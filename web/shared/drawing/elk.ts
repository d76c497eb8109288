// The part of ELK's graph format that the drawing uses, and the engine as a value: a worker in the page, in-process in tests.

export type ElkOptions = Readonly<Record<string, string>>;

export interface ElkShape {
  readonly id: string;
  readonly x?: number;
  readonly y?: number;
  readonly width?: number;
  readonly height?: number;
  readonly layoutOptions?: ElkOptions;
}

export interface ElkEdge {
  readonly id: string;
  readonly sources: string[];
  readonly targets: string[];
  readonly labels?: (ElkShape & { readonly text: string })[];
  readonly sections?: readonly {
    readonly startPoint: { readonly x: number; readonly y: number };
    readonly endPoint: { readonly x: number; readonly y: number };
    readonly bendPoints?: readonly { readonly x: number; readonly y: number }[];
  }[];
}

export interface ElkGraph extends ElkShape {
  readonly ports?: ElkShape[];
  readonly children?: ElkGraph[];
  readonly edges?: ElkEdge[];
}

/** Lays a graph out; the answer has the same shape with positions. */
export type LayoutEngine = (graph: ElkGraph) => Promise<ElkGraph>;
