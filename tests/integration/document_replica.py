"""A document as a client has it that applies the accepted edits (api/schemas/edit.json), written apart from the server's."""
import copy
import hashlib
import json

LISTS = ("parameters", "results", "variables", "actions", "children", "ports")


def elements(document):
    """(element, the list in which it stands or None, its parent's id or "", the name of the list) of each, the root first."""
    yield document["root"], None, None, None
    waiting = [document["root"]]
    for state in document.get("library", []):
        yield state, document["library"], "", "library"
        waiting.append(state)
    while waiting:
        parent = waiting.pop()
        for name in LISTS:
            for element in parent.get(name, []):
                yield element, parent[name], parent["meta"]["id"], name
                waiting.append(element)


def find(document, id):
    """As elements() has it."""
    [found] = [each for each in elements(document) if each[0]["meta"]["id"] == id]
    return found


def take_out(document, id):
    element, siblings, parent, name = find(document, id)
    siblings[:] = [each for each in siblings if each is not element]
    if not siblings:
        del (document if parent == "" else find(document, parent)[0])[name]
    return element


def put_in(document, element, operation):
    parent = find(document, operation["parent"])[0] if operation["parent"] else document
    siblings = parent.setdefault(operation["list"], [])
    at = 0
    if "after" in operation:
        at = 1 + next(i for i, each in enumerate(siblings) if each["meta"]["id"] == operation["after"])
    siblings.insert(at, element)


def entries(document, operation):
    """(object that has the entries, name of the entries in it), or (object, None) if its field is set as a whole."""
    field = operation["field"]
    if operation["id"]:
        return find(document, operation["id"])[0], "meta" if "key" in operation else None
    if field == "notes":
        return document.setdefault("meta", {}), "notes"
    return document, field if "key" in operation else None


def put_value(owner, key, operation):
    is_nothing = key == "doc" and operation.get("value") == ""
    if "value" in operation and not is_nothing:
        owner[key] = copy.deepcopy(operation["value"])
    else:
        owner.pop(key, None)


def set_value(document, operation):
    owner, name = entries(document, operation)
    if name is None:
        put_value(owner, operation["field"], operation)
        return
    put_value(owner.setdefault(name, {}), operation["key"], operation)
    if not owner[name]:
        del owner[name]
    if document.get("meta") == {}:
        del document["meta"]


def apply(document, operations):
    """Applies the operations to the document (JSON) in place. Error, whatever it is: one cannot be applied."""
    for operation in operations:
        if operation["op"] == "insert":
            put_in(document, copy.deepcopy(operation["node"]), operation)
        elif operation["op"] == "remove":
            take_out(document, operation["id"])
        elif operation["op"] == "move":
            put_in(document, take_out(document, operation["id"]), operation)
        else:
            set_value(document, operation)


def digest(document):
    """SHA-256 of its canonical JSON."""
    return hashlib.sha256(json.dumps(document, sort_keys=True, separators=(",", ":")).encode()).hexdigest()


class Replica:
    """What a subscriber of `document/NAME` has. `errors`: the violations of the document; `sound`: the last revision that it
    has seen without any."""

    def __init__(self):
        self.document, self.revision, self.sequence = None, 0, None
        self.errors, self.sound = [], 0
        self.accepted = {}

    def take(self, message):
        """A snapshot or delta of the channel. AssertionError: an edit is missing."""
        data = message["data"]
        self.sequence = message["sequence"]
        if message["kind"] == "snapshot":
            self.document = copy.deepcopy(data["json"])
        else:
            assert data["revision"] == self.revision + 1, (data["revision"], self.revision)
            apply(self.document, data["operations"])
            self.accepted[data["revision"]] = data
        self.revision, self.errors = data["revision"], data["errors"]
        if not self.errors:
            self.sound = self.revision
