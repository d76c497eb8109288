"""Conversations of api/conversations, held with a client of the Python library; what goes to and fro is held against api/, too."""
import contextlib
import json
import operator
import sys
import time

from accounts import AccountServer
from client import PROJECT, TIMEOUT, Server, check
from conversation_values import API, FOLDER, Values, at, mismatch, value_of
from interface import check_listed
from python_clients import race_client

sys.path.append(str(API / "python" / "generate"))

from calls import snake
from routes import all_routes

ROUTES = {route.operation_id: route for route in all_routes()}
# With which a conversation is held.
SERVERS = {"plain": Server, "accounts": AccountServer, "demo": lambda: Server("--demo", str(PROJECT / "deploy/demo"))}
OF_ERRORS = ("status", "code", "path", "errors", "may_be_done", "service", "operation", "error")


def all_conversations():
    """(name of its file, conversation) of each."""
    return [(path.stem, each) for path in sorted(FOLDER.glob("*.json")) for each in json.loads(path.read_text())["conversations"]]


def error_fields(error):
    """What a pattern may say of an error."""
    return {name: getattr(error, name) for name in OF_ERRORS if hasattr(error, name)}


def update_fields(update):
    """What a pattern may say of an update, once it is of its schemas; None: there is none."""
    if update is None:
        return None
    check("core_state", update.state)
    if update.delta is not None:
        check("core_delta", update.delta)
    return vars(update)


class Conversation:
    """One conversation. `client_of`: makes a client with a token of an account; of None, without one."""

    def __init__(self, client_of):
        self.client_of = client_of
        self.clients = {}
        self.saved = Values()
        self.updates = None
        self.stack = contextlib.ExitStack()

    def hold(self, steps):
        """All steps, one after the other. AssertionError: something else came than a step says."""
        with self.stack:
            for number, step in enumerate(steps, 1):
                why = self.hold_step(step)
                if why is not None:
                    raise AssertionError(f"step {number}, {json.dumps(step)[:300]}: {why}")

    def hold_step(self, step):
        """Why a step does not come to what it says; None: it does."""
        end = time.monotonic() + TIMEOUT
        while True:
            answer, error = self.outcome(step)
            if error is not None:
                return mismatch(step["refused"], error, self.saved) if "refused" in step else f"it is refused: {error}"
            if "refused" in step:
                return f"it is answered: {str(answer)[:300]}"
            why = next((mismatch(step[name], answer, self.saved) for name in ("answer", "until") if name in step), None)
            if why is None:
                self.saved.update({name: at(answer, pointer) for name, pointer in step.get("save", {}).items()})
            if why is None or "until" not in step or time.monotonic() > end:
                return why
            time.sleep(0.02)

    def outcome(self, step):
        """(answer, None), or (None, what is said of the error)."""
        try:
            return self.do(step), None
        except race_client.RaceError as error:
            if "call" in step and error.status >= 300:
                route = ROUTES[step["call"]]
                check_listed(route.method.upper(), route.path, error.status, {"errors": error.errors})
            return None, error_fields(error)

    def do(self, step):
        """What a step is answered."""
        if "let" in step:
            self.saved.update(value_of(step["let"], self.saved))
            return None
        if "next" in step:
            return update_fields(self.updates.next(step["within"]) if "within" in step else next(self.updates, None))
        if "rest" in step:
            return [update_fields(each) for each in self.updates]
        race = self.client(step.get("by"))
        options = {name: value_of(given, self.saved) for name, given in step.get("options", {}).items()}
        if "follow" in step:
            core = value_of(step["follow"], self.saved)
            self.updates = self.stack.enter_context(race.cores.follow(core, **{"quiet": TIMEOUT, **options}))
            return None
        return self.call(race, step) if "call" in step else self.ask(race, step, options)

    def client(self, account):
        if account not in self.clients:
            self.clients[account] = self.client_of(account)
        return self.clients[account]

    def ask(self, race, step, options):
        words = value_of(step.get("arguments", []), self.saved)
        if step["ask"] == "services.call":  # in Python, arguments of the operation are its own
            service, called, args, kwargs = *words, *([], {})[len(words) - 2:]
            words, options = [service, called, *args], {**options, **kwargs}
        answer = operator.attrgetter(step["ask"])(race)(*words, **options)
        return list(answer) if hasattr(answer, "__next__") else answer

    def call(self, race, step):
        route = ROUTES[step["call"]]
        value = {name: value_of(step.get(name, {}), self.saved) for name in ("path", "query", "headers")}
        words = [*value["path"].values(), *([value_of(step["body"], self.saved)] if "body" in step else [])]
        named = {snake(name): given for name, given in {**value["query"], **value["headers"]}.items()}
        answer = race.send(getattr(race_client.calls, snake(step["call"]))(*words, **named))
        if step.get("body") is not None:
            check(route.body.removesuffix(".json"), words[-1])
        if route.answer:
            check(route.answer.removesuffix(".json"), answer)
        return answer
