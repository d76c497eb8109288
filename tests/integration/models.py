"""Small tasks that the tests run."""


def document(name, root, **more):
    return {"rcm": 1, "name": name, "root": root, **more}


def without_ids(value):
    """A document as it was before the server gave its elements ids."""
    if isinstance(value, list):
        return [without_ids(item) for item in value]
    if not isinstance(value, dict):
        return value
    return {key: without_ids(item) for key, item in value.items() if key != "meta" or set(item) != {"id"}}


def ticking(name="ticking", last=5):
    """Counts ticks of the timer in two alternating states; ends at `done` after `last` ticks."""
    toggle = lambda me, other: {
        "state": me, "ports": [{"name": "next", "when": "svc.timer.tick", "to": other}]}
    return document(name, {
        "state": "Root", "results": [{"name": "n", "initial": 0}],
        "parameters": [{"name": "last", "value": last}],
        "actions": [{"when": "svc.timer.tick", "do": "res.n = res.n + 1"}],
        "children": [toggle("Ping", "Pong"), toggle("Pong", "Ping")], "first": "Ping",
        "ports": [{"name": "done", "when": "res.n >= par.last"}]})


def hurrying(name="hurrying"):
    """Goes to and fro between two states, each for 1 ms, without an end."""
    brief = lambda me, other: {
        "state": me, "entry": "svc.timer.wait(0.001)", "ports": [{"name": "done", "when": "svc.timer.wait.result", "to": other}]}
    return document(name, {
        "state": "Root", "children": [brief("Ping", "Pong"), brief("Pong", "Ping")], "first": "Ping",
        "ports": [{"name": "never", "when": "False"}]})


def storing(name="storing"):
    """Stores its argument in the database, reads it again and returns it as result."""
    return document(name, {
        "state": "Root", "parameters": [{"name": "key", "value": "x"}, {"name": "value"}],
        "results": [{"name": "read"}],
        "actions": [{"when": "available(chi.Get.res.value)", "do": "res.read = chi.Get.res.value"}],
        "children": [
            {"state": "Add", "parameters": [{"name": "key", "from": "par.key"}, {"name": "value", "from": "par.value"}],
             "entry": "svc.db.add(par.key, par.value)",
             "ports": [{"name": "success", "when": "svc.db.add.result", "to": "Get"},
                       {"name": "error", "when": "svc.db.add.error"}]},
            {"state": "Get", "parameters": [{"name": "key", "from": "par.key"}], "results": [{"name": "value"}],
             "entry": "svc.db.get(key=par.key)",
             "actions": [{"when": "svc.db.get.result", "do": "res.value = svc.db.get.result"}],
             "ports": [{"name": "success", "when": "available(res.value)"}]}],
        "first": "Add",
        "ports": [{"name": "success", "when": "chi.Get.port.success"}, {"name": "error", "when": "chi.Add.port.error"}]})


def reading(name="reading"):
    """Reads a key of the database: `found` with its value as result, or `missing`."""
    return document(name, {
        "state": "Root", "parameters": [{"name": "key"}], "results": [{"name": "value"}],
        "entry": "svc.db.get(par.key)",
        "actions": [{"when": "svc.db.get.result", "do": "res.value = svc.db.get.result"}],
        "ports": [{"name": "found", "when": "available(res.value)"}, {"name": "missing", "when": "svc.db.get.error"}]})


def chain(name="chain"):
    """Four states, one after the other without waiting: one macro step of many micro steps."""
    states = [{"state": f"S{i}", "ports": [{"name": "next", "when": "True", "to": f"S{i + 1}"}]} for i in range(3)]
    return document(name, {"state": "Root", "children": [*states, {"state": "S3"}], "first": "S0",
                           "ports": [{"name": "done", "when": "svc.timer.elapsed"}]})


def slow(name="slow", lists=100):
    """Ends after one macro step, whose conditions make twice as many large lists: each takes some milliseconds."""
    large = "len([i for i in range(200000)]) > 0"
    return document(name, {
        "state": "Root", "parameters": [{"name": "lists", "value": lists}], "first": "A",
        "children": [{"state": "A", "keep": True, "parameters": [{"name": "lists", "from": "par.lists"}],
                      "results": [{"name": "n", "initial": 0}], "entry": "res.n += 1",
                      "ports": [{"name": "next", "when": f"{large} and res.n < par.lists", "to": "B"}]},
                     {"state": "B", "ports": [{"name": "next", "when": large, "to": "A"}]}],
        "ports": [{"name": "done", "when": "chi.A.res.n >= par.lists"}]})


def waiting(seconds, times=1, name="waiting"):
    """Enters a state with a time-out as often, at once; ends at `late` when it has been in it for so long at last."""
    return document(name, {
        "state": "Root", "parameters": [{"name": "times", "value": times}], "first": "Ask",
        "children": [{
            "state": "Ask", "parameters": [{"name": "times", "from": "par.times"}], "variables": [{"name": "n", "initial": 0}],
            "keep": True, "entry": "var.n += 1",
            "ports": [{"name": "again", "when": "var.n < par.times", "to": "Ask"},
                      {"name": "late", "after": f"60 if var.n < par.times else {seconds}"}]}],
        "ports": [{"name": "late", "when": "chi.Ask.port.late"}]})


def faulty(name="faulty"):
    """Divides by zero at the first tick."""
    return document(name, {"state": "Root", "variables": [{"name": "zero", "initial": 0}],
                           "actions": [{"when": "svc.timer.tick", "do": "var.x = 1 / var.zero"}]})


def calling(service, operation, name="calling", computed=False):
    """Calls once: `result` or `error`. `computed`: the name of the service is an expression."""
    answer = f"svc['{service}'].{operation}" if computed else f"svc.{service}.{operation}"
    return document(name, {"state": "Root", "entry": f"{answer}()", "results": [{"name": "code"}],
                           "actions": [{"when": f"{answer}.error", "do": f"res.code = {answer}.error.code"}],
                           "ports": [{"name": "result", "when": f"{answer}.result"},
                                     {"name": "error", "when": "available(res.code)"}]})


def working(name, to, numbers=60000):
    """A state that is left at once, but for a condition that makes a list of so many: 60 000 take milliseconds."""
    return {"state": name, "ports": [{"name": "next", "when": f"len([i for i in range({numbers})]) > 0", "to": to}]}


def diverging(name="diverging", numbers=60000):
    """One macro step of 10 000 micro steps, each with a list of so many numbers."""
    return document(name, {"state": "Root", "first": "A", "children": [working("A", "B", numbers), working("B", "A", numbers)]})
