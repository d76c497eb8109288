// What a task is made of (thesis, chapters 3 and 4; core/SEMANTICS.md).
import { code, figure, heading, list, terms, text, type Topic } from "./blocks";
import * as examples from "./examples";

const group = "Tasks" as const;

export const concepts: readonly Topic[] = [
  {
    id: "state", title: "States", group,
    blocks: [
      text("A task is a hierarchy of states. A state says what is done while it is active: what it starts when it is entered, what it does when something happens, and on which condition it is left."),
      figure(examples.grasp, "A state with parameters, a result, an entry function, an action and two ports (thesis, Figure 3.3)"),
      terms(
        ["Parameters", "what the state is told when it is entered"],
        ["Results", "what it has found out, for the states around it"],
        ["Variables", "what it remembers for itself"],
        ["Entry, exit", "functions that are executed once, when it is entered and when it is left"],
        ["Actions", "functions with a condition: executed whenever that holds while the state is active"],
        ["Ports", "the ways out, each with a condition"],
      ),
      text("A state is active from the moment in which something leads to it until one of its ports fires or the state around it is left. A double click shows its properties, in the editor as the state editor."),
    ],
  },
  {
    id: "hierarchy", title: "States within states", group,
    blocks: [
      text("A composite state has states inside. When it is entered, its `first` one is entered, too. When it is left, everything inside is left."),
      figure(examples.pick, "Pick holds Move and Grasp; Move is the first (thesis, Figure 3.4)"),
      text("A port leads to a state next to its own, never into another level. What leaves the composite is a port of the composite, often with a condition such as `chi.Grasp.port.success`: the port `success` of the child Grasp has fired."),
      text("So a composite can be understood, reused and tested by its parameters, results and ports alone."),
    ],
  },
  {
    id: "ports", title: "Ports and conditions", group,
    blocks: [
      text("A port fires when its condition is True. Then its state is left, and the state that the port leads to is entered in the same micro step. A port that leads nowhere stays active, so that the state around can use it in its own conditions."),
      figure(examples.choice, "Two ports that can fire at once: the order decides"),
      text("Ports are tested in the order in which they stand, from top to bottom; the first that is fulfilled fires. The order is shown where two can conflict, and changed by dragging the rows."),
      heading("True, False and unknown"),
      text("What is not there yet is unknown: a result without a value, a response that has not come. A condition with something unknown is unknown, unless the rest decides it: `False and x` is False whatever x is. A port fires only if its condition is True. `available(x)` is True or False, never unknown."),
      text("Click a port to see why it fires, or does not; a state to ask the same of its actions, and where its parameters come from."),
    ],
  },
  {
    id: "barriers", title: "Barriers: side by side", group,
    blocks: [
      text("A barrier is a bar. It waits until all ports that lead to it have fired, then it enters all states that it leads to. So it splits a task into parts that run side by side, and joins them again."),
      figure(examples.barrier, "The first barrier starts two states, the second waits for both (thesis, Figure 3.5)"),
      text("While it waits it shows how many have arrived. A barrier leads to states, not to other barriers."),
    ],
  },
  {
    id: "values", title: "Parameters, results, variables", group,
    blocks: [
      text("Parameters go down: a parameter is a constant, or an expression over the parameters, results and variables of the state around it. It gets its value when its state is entered. Results come up: the state around reads them as `chi.Child.res.name`."),
      figure(examples.values, "a and b go down into Add, the sum comes up"),
      terms(
        ["par.x", "a parameter of the state; read only"],
        ["res.x", "a result; read, and written by functions"],
        ["var.x", "a variable; read, and written by functions"],
        ["port.p", "whether the port p of the state is active"],
        ["chi.C.par.x, chi.C.res.x", "of the child C"],
        ["chi.C.active, chi.C.port.p", "whether the child C, or its port p, is active"],
        ["svc.S.op, svc.S.ev", "operations and events of the service S"],
      ),
      text("That is all that a state can see (its scope): nothing of its neighbours, nothing deeper. A parameter with neither a constant nor an expression is required: whoever starts the task, or links the state, gives it."),
    ],
  },
  {
    id: "services", title: "Services", group,
    blocks: [
      text("Robots, grippers, cameras, displays are services. A service has operations that a task calls, and events that it tells. What a service accepts depends on its state, which its model (RSM) says: the page Services draws it, with the present state lit."),
      code("svc.gripper.grasp(width=0.03)            # in a function: calls the operation", "svc.gripper.grasp.result                 # in a condition: it has answered", "svc.gripper.grasp.error                  # in a condition: it has failed", "svc.robot.collision                      # in a condition: the event has occurred"),
      list(
        "Left of the drawing, under Services, are the operations of each service: dragged onto the drawing, or by Enter, a state is added that calls one, with its parameters, results and ports.",
        "A call is a statement of its own. It does not wait: the answer comes later, and a condition sees it.",
        "A call that a service does not accept now is answered with the error `not_accepted`; one to a service that is not there with `unavailable`.",
        "Operations that no reachable state of the service accepts are struck through in the list of completions.",
        "When a run faults or is stopped, the `safe` operations of the services that it has called are called, such as `robot.stop`.",
      ),
    ],
  },
  {
    id: "links", title: "Links and the library", group,
    blocks: [
      text("A state that is needed more than once stands in the library of the document. A state with a link is that state, with parameters of its own. A change of the library state changes all links."),
      text("Select a state and choose Extract into the library; drag a library state onto the drawing to link it. Linked states are drawn as composites that can be opened, but are edited in the library."),
    ],
  },
  {
    id: "oracles", title: "Oracles and histories", group,
    blocks: [
      text("Which child is entered first can be decided when the state is entered: by an expression, by a service, or by what was active when the state was left."),
      figure(examples.history, "Task goes on where it was when its port error had fired (thesis, Figure 3.9)"),
      terms(
        ["expr", "an expression that gives the name of a child"],
        ["external", "a service is asked"],
        ["history", "the child that was active when the state was left; `deep`: also what was active inside of that"],
      ),
      text("Oracles are translated to plain states before a run; the derivation shows that."),
    ],
  },
  {
    id: "time", title: "Time-outs", group,
    blocks: [
      text("A port with `after` in place of a condition fires that many seconds after its state was entered."),
      figure(examples.timeOut, "A question that gives up after 20 s"),
      text("Time goes on while a run is paused: the port fires when the run goes on."),
    ],
  },
];
