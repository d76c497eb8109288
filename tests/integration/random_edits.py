"""What an author of a document wants, by chance: inserts, removes, moves, connects, renames, groups. Most of it leaves a task
that can be executed; of what does not, its author takes back what he can, or somebody restores the last one that could."""
from document_replica import elements

NEW = {"parameters": {"value": 1}, "variables": {"initial": 1}, "children": {}, "ports": {"when": "svc.timer.tick"}}
LONG_A_DRAFT = 8  # revisions
LARGE = 150  # elements: from then on more are removed than inserted


class RandomEdits:
    """One author's. Names and ids that it gives are nobody else's."""

    def __init__(self, name, chance):
        self.name, self.random, self.number = name, chance, 0

    def next(self, replica):
        """A request but for its token, or {"restore": revision}. `replica`: what the author has seen."""
        self.document = replica.document
        if replica.errors:
            made_it = replica.accepted.get(replica.sound + 1, {}).get("author") == self.name
            if made_it and self.random.random() < 0.8:
                return {"undo": True}
            if replica.revision - replica.sound > LONG_A_DRAFT and self.random.random() < 0.2:
                return {"restore": replica.sound}
        kind = self.random.random()
        if kind < 0.1:
            return {"undo": True}
        if kind < 0.14:
            return {"redo": True}
        if kind < 0.25:
            return {"compound": self.compound()}
        return {"operations": [each for _ in range(self.random.choice((1, 1, 1, 2, 3))) for each in self.operations()]}

    # What there is

    def pick(self, *conditions):
        """An element, (element, its list, its parent's id, name of the list), for which all hold; None if there is none."""
        found = [each for each in elements(self.document) if all(condition(*each) for condition in conditions)]
        return self.random.choice(found) if found else None

    def composite(self):
        """The id of a state that has its own elements (what links has its library state's)."""
        return self.pick(lambda element, *_: "state" in element and "link" not in element)[0]["meta"]["id"]

    def is_large(self):
        return sum(1 for _ in elements(self.document)) > LARGE

    def siblings_in(self, parent):
        """Names of the states in this state."""
        return [element["state"] for element, _, owner, name in elements(self.document)
                if owner == parent and name == "children" and "state" in element]

    def is_loose(self, element, siblings, parent, name):
        """Whether it was added to the task, and nothing names it."""
        if name in ("parameters", "variables", "ports"):
            return self.is_new(element["name"])
        if name != "children" or not self.is_new(element.get("state", "")):
            return False
        owner = next(each for each, *_ in elements(self.document) if each["meta"]["id"] == parent)
        named = {owner.get("first")} | {port.get("to") for each in siblings for port in each.get("ports", ())}
        named |= {to for each in siblings if "barrier" in each for to in each["to"]}
        return element["state"] not in named

    @staticmethod
    def is_new(name):
        return "_" in name

    # What it does

    def new_name(self):
        self.number += 1
        return f"N_{self.name}{self.number}"

    def place(self, parent, kind):
        siblings = [element["meta"]["id"] for element, _, owner, name in elements(self.document) if (owner, name) == (parent, kind)]
        after = {"after": self.random.choice(siblings)} if siblings and self.random.random() < 0.7 else {}
        return {"parent": parent, "list": kind, **after}

    def port(self, name, siblings):
        return {"name": name, **NEW["ports"], "to": self.random.choice(siblings), "meta": {"id": self.new_name()}}

    def node(self, kind, parent):
        name = self.new_name()
        node = {"state" if kind == "children" else "name": name, **NEW[kind], "meta": {"id": name}}
        if kind == "children":
            node["ports"] = [self.port("next", self.siblings_in(parent) or [name])]
        return node

    def operations(self):
        """Those of one change."""
        remove = 60 if self.is_large() else 12
        change = self.random.choices((self.insert, self.insert_port, self.connect, self.remove, self.move, self.annotate),
                                     (30, 8, 12, remove, 12, 26))[0]
        return change() or self.annotate()

    def insert(self):
        kind, parent = self.random.choice(("parameters", "variables", "children")), self.composite()
        return [{"op": "insert", **self.place(parent, kind), "node": self.node(kind, parent)}]

    def insert_port(self):
        """On a state below another: the root is never left."""
        if found := self.pick(lambda element, _, __, name: name == "children" and "state" in element and "link" not in element):
            element, _, parent, _ = found
            port = self.port(self.new_name(), self.siblings_in(parent))
            return [{"op": "insert", **self.place(element["meta"]["id"], "ports"), "node": port}]
        return None

    def connect(self):
        """A port that is there to another state."""
        if found := self.pick(lambda _, __, ___, name: name == "ports"):
            port, _, state, _ = found
            parent = next(owner for element, _, owner, _ in elements(self.document) if element["meta"]["id"] == state)
            if siblings := self.siblings_in(parent):
                return [{"op": "set", "id": port["meta"]["id"], "field": "to", "value": self.random.choice(siblings)}]
        return None

    def remove(self):
        """What nothing names; now and then, anything but a port: each state keeps one, which leads on."""
        anything = self.random.random() < 0.15
        if found := self.pick(lambda *each: (anything and each[2] and each[3] != "ports") or self.is_loose(*each)):
            return [{"op": "remove", "id": found[0]["meta"]["id"]}]
        return None

    def move(self):
        """Among its siblings; or what nothing names to another state, with its ports connected there."""
        if self.random.random() < 0.5:
            found = self.pick(lambda _, __, parent, name: parent and name == "children")
            return [{"op": "move", "id": found[0]["meta"]["id"], **self.place(found[2], "children")}] if found else None
        if not (found := self.pick(lambda *each: each[3] == "children" and self.is_loose(*each))):
            return None
        state, parent = found[0], self.composite()
        siblings = self.siblings_in(parent) or [state["state"]]
        ports = [{"op": "set", "id": port["meta"]["id"], "field": "to", "value": self.random.choice(siblings)}
                 for port in state.get("ports", ())]
        return [{"op": "move", "id": state["meta"]["id"], **self.place(parent, "children")}, *ports]

    def annotate(self):
        id, kind = self.pick()[0]["meta"]["id"], self.random.random()
        if kind < 0.35:
            entry = {"value": {"x": self.random.randrange(99)}} if self.random.random() < 0.8 else {}
            return [{"op": "set", "id": "", "field": self.random.choice(("layout", "meta")), "key": id, **entry}]
        if kind < 0.7:
            return [{"op": "set", "id": id, "field": "meta", "key": "title", "value": self.name}]
        return [{"op": "set", "id": id, "field": "doc", "value": f"{self.name} {self.random.randrange(999)}"}]

    def compound(self):
        state, name = self.composite(), self.new_name()
        return self.random.choices(
            ({"kind": "rename", "id": state, "name": name}, {"kind": "duplicate", "id": state},
             {"kind": "group", "ids": [state], "name": name}, {"kind": "ungroup", "id": state},
             {"kind": "extract", "id": state, "name": name}), (6, 0 if self.is_large() else 3, 2, 1, 1))[0]
