// What the guide and the teaching of poses say: a file for each language has all of it.

/** Of one step of the guide. */
export interface StepTexts {
  readonly title: string;
  /** What is to be done, in one or two sentences. */
  readonly todo: string;
}

export interface Texts {
  readonly offer: { readonly title: string; readonly about: string; readonly begin: string };
  readonly guide: {
    readonly name: string;
    readonly count: (step: number, of: number) => string;
    readonly back: string;
    readonly next: string;
    readonly leave: string;
  };
  readonly cell: StepTexts & {
    readonly list: string;
    readonly robot: string;
    readonly gripper: string;
    readonly camera: string;
    readonly noRobot: string;
    readonly noGripper: string;
    readonly noCamera: string;
    readonly asking: string;
    /** Without it nothing can be picked. */
    readonly cannot: string;
    readonly noSkills: (what: string) => string;
  };
  readonly camera: StepTexts & {
    readonly asking: string;
    /** Why nothing is to be done. */
    readonly known: string;
    readonly notNeeded: (why: string) => string;
    readonly begin: string;
    readonly making: string;
    readonly task: string;
    readonly skip: string;
  };
  readonly part: StepTexts & { readonly stem: string; readonly check: string };
  readonly place: StepTexts & { readonly stem: string; readonly height: (millimetres: string) => string; readonly sameHeight: string };
  readonly application: StepTexts & {
    readonly wish: string;
    readonly task: string;
    readonly make: string;
    readonly making: string;
    readonly line: string;
    readonly missingPoses: string;
    readonly change: string;
  };
  readonly run: StepTexts & { readonly done: string; readonly again: string; readonly toBuild: string; readonly toAll: string };
  readonly teach: {
    readonly open: string;
    readonly close: string;
    readonly name: string;
    readonly how: string;
    readonly ways: { readonly tool: string; readonly joints: string; readonly hand: string };
    readonly noRobot: string;
    readonly notMoved: (why: string) => string;
    readonly at: (x: string, y: string, z: string) => string;
  };
  readonly problem: (why: string) => string;
  /** Before an application is left whose edits the server has not taken. */
  readonly leave: {
    readonly title: (edits: number) => string;
    readonly lost: string;
    readonly savedTitle: string;
    readonly saved: string;
    readonly stay: string;
    readonly leave: string;
    readonly giveUp: string;
  };
}
