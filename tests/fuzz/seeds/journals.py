"""Journals of the cases of tests/conformance whose model is native as it stands, and files of their runs."""
import json

from seeds.project import EXAMPLES, compact, examples, read, scripts

BUDGETS = {"steps": 2000, "value_units": 10000, "micro_steps": 200}  # support/bounded_header.h
NOT_NATIVE = ('"link"', '"oracle"', '"after"', '"library"')


def elements(state, path):
    """Paths of a state, of all below it, and of their ports, as `origin` of a native model has them."""
    yield path
    yield from (f"{path}.{port['name']}" for port in state.get("ports", []))
    for child in state.get("children", []):
        yield from elements(child, f"{path}/{child.get('state') or child.get('barrier')}")


def entries(script):
    """What a script says, as entries of a journal."""
    inputs = [{"kind": "start"}]
    calls = 0
    for step in script["steps"]:
        inputs += [{"kind": "event", **event} for event in step.get("events", [])]
        for response in step.get("responses", []):
            calls += 1
            answer = {"error": response["error"]} if "error" in response else {"result": response.get("result")}
            inputs.append({"kind": "response", "service": response["service"], "operation": response["operation"],
                           "call": calls, **answer})
        inputs += [{"kind": "force", "force": step["force"]}] if "force" in step else []
    return [{"position": number, "input": each} for number, each in enumerate(inputs, 1)]


def interface(service):
    def items(key, flag):
        return [{name: item[name] for name in ("name", flag) if name in item} for item in service.get(key, [])]

    return {"operations": items("operations", "safe"), "events": items("events", "sampled")}


def journal(model, script):
    origin = {path: path for path in elements(model["root"], model["root"]["state"])}
    services = {key: interface(service) for key, service in script.get("services", {}).items()}
    header = {"native": {"document": model, "origin": origin}, "arguments": script.get("arguments", {}),
              "services": services, "semantics": "1", "budgets": BUDGETS}
    return {"header": header, "entries": entries(script)}


def journals():
    made = []
    for case, script in scripts().items():
        text = (case / "model.json").read_text(encoding="utf-8")
        if not case.name.startswith("errors-") and not any(word in text for word in NOT_NATIVE):
            made.append(journal(json.loads(text), script))
    return [compact(each) for each in [*examples("journal.*.json"), *made]]


def run_files():
    """The target mends chain and number of steps. What a run came to it does not: so they are files of runs that go on."""
    file = read(EXAMPLES / "run_file.ticking.json")
    record = {**file["run"], "status": "running"}
    made = [{**file, "run": record, "journal": json.loads(each), "samples": file["samples"][:2]} for each in journals()]
    return [compact(each) for each in [file, *made]]
