"""Brings a draft to its end: has it checked, mends it, stores it, runs it, and follows what happens."""
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

from race_client import Client, RaceError, Update

from . import repair
from .compose import document_of
from .refusal import Refused
from .scene import is_calibrated
from .skills import Skill, is_planned
from .tasks import FINAL, ROOT, Draft, Step, calibrating, steps_of

UPDATE_TIMEOUT = 120.0  # [s] without an update of the run after which it is ended


@dataclass(frozen=True)
class Failure:
    """The error that has stopped a run, and the part that was moved when it came."""

    text: str
    label: str | None = None


class Runner:
    """Runs drafts on a server, each as the next revision of the document `name`. `say` is told each step.

    Refused: somebody else has a document of this name.
    """

    def __init__(self, race: Client, skills: Mapping[str, Skill], say: Callable[[str], None], name: str) -> None:
        self._race, self._skills, self._say, self._name = race, skills, say, name
        self._revision = own_revision(race, name)

    def run(self, draft: Draft, poses: Mapping[str, Any] | None = None) -> Failure | None:
        """None: it has succeeded. `poses`: what the database has to know before it starts.

        Refused: it is not accepted, or has not run to its end. RaceError: the server refuses or is gone, or the document was changed by
        somebody else. Whatever ends this, also Ctrl-C, ends the run.
        """
        draft = self.store(draft, poses)
        core = self._race.cores.create(self._name)
        try:
            if core["revision"] != self._revision:
                raise Refused(f"somebody else has changed the document {self._name}")
            return self._follow(core["id"], draft)
        except BaseException:
            self._stop(core["id"])
            raise

    def store(self, draft: Draft, poses: Mapping[str, Any] | None = None) -> Draft:
        """As `run`, but it is not run: the draft as it was stored."""
        draft = self._accepted(draft)
        stored = self._race.documents.put(self._name, document_of(draft, self._skills), if_revision=self._revision,
                                          is_new=self._revision is None, author="planner", message=draft.title)
        self._revision = stored["revision"]
        for key, value in (poses or {}).items():
            self._race.services.call("db", "add", key, value)
        return draft

    def complete(self, draft: Draft) -> None:
        """As `run`. Refused: also what has stopped it."""
        failure = self.run(draft)
        if failure is not None:
            raise Refused(failure.text)

    def calibrate(self, speed: float) -> None:
        """Finds out where the camera stands, if nobody knows. As `complete`."""
        if not is_calibrated(self._race):
            self._say("nobody knows where the camera stands: it is calibrated")
            self.complete(calibrating(self._name, speed))

    def _stop(self, core: str) -> None:
        """What the run moves stops."""
        try:
            self._race.cores.delete(core)
        except RaceError as error:
            self._say(f"core {core} may go on: {error}")

    def _accepted(self, draft: Draft) -> Draft:
        """The draft, mended until nothing is wrong with it."""
        for _ in range(repair.ROUNDS):
            here = frozenset(service["key"] for service in self._race.services.all() if service["available"])
            errors = repair.errors_of(draft, self._skills, here, self._race)
            if not errors:
                return draft
            for error in errors:
                self._say(f"  refused: {error['path']}: {error['code']}: {error['message']}")
            draft = repair.repaired(draft, errors, self._skills)
        raise Refused("the document is refused however often it is mended")

    def _follow(self, core: str, draft: Draft) -> Failure | None:
        """Starts it, and tells each step that ends. Of steps that end while the connection is lost, nothing is told."""
        steps = steps_of(draft)
        labels = {f"{ROOT}/{task.path}/{step.name}": task.label for task in draft.tasks for step in task.steps}
        failure = Failure("the run has ended with an error")
        with self._race.cores.follow(core) as updates:
            self._race.cores.start(core)
            while (update := updates.next(UPDATE_TIMEOUT)) is not None:
                if update.kind == "disconnected":
                    self._say(f"  the connection is lost: {update.reason}")
                for path, port in ended_by(update, steps):
                    text = self._report(path, steps[path], port, update)
                    if port in FINAL:
                        raise Refused(text)
                    if port in self._skills[steps[path].skill].errors and not steps[path].goes_on:
                        failure = Failure(text, labels[path])
        ended = self._race.cores.get(core)
        if ended["status"] != "ended":
            raise Refused(f"the run is {ended['status']}")
        return None if ended.get("outcome") == "success" else failure

    def _report(self, path: str, step: Step, port: str, update: Update) -> str:
        """Says how a step has ended, and why; returns what it has said."""
        why = update.state["state"]["results"].get(path, {}).get("why")
        text = f"{path.partition('/')[2]}: {self._skills[step.skill].port_title(port)}" + (f" ({why})" if why else "")
        self._say(f"  {text}")
        return text


def ended_by(update: Update, steps: Mapping[str, Step]) -> list[tuple[str, str]]:
    """(path, port) of the steps that have ended with an update."""
    fired = update.delta["fired"] if update.delta is not None else []
    ends = [port.rpartition(".") for port in fired]
    return [(path, port) for path, _, port in ends if path in steps]


def own_revision(race: Client, name: str) -> int | None:
    """The last revision of the document that the planner has written before; None: there is none of this name."""
    try:
        entry = race.documents.get(name)
    except RaceError as error:
        if error.status == 404:
            return None
        raise
    if not is_planned(entry["document"]):
        raise Refused(f"the document {name} is not the planner's")
    return entry["revision"]
