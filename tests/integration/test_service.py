"""The service of systemd and the container: the unit verified and rated, what a real run asks of the kernel against its filter;
what the Dockerfile copies and asks for health."""
import json
import os
import re
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

import models
from client import PROGRAM, PROJECT, TIMEOUT, Server
from motions import moving
from traced_server import strace

UNIT = PROJECT / "deploy/race.service"
MOST_EXPOSED = 1.5  # of 10, as systemd-analyze rates it
NEEDED = "this test needs systemd-analyze: deploy/install (package systemd)"


def analyze(*words):
    program = shutil.which("systemd-analyze")
    assert program, NEEDED
    return subprocess.run([program, "--no-pager", *words], capture_output=True, text=True, timeout=TIMEOUT, check=False)


def settings():
    """(key, value) of each line of the unit's [Service]."""
    lines = UNIT.read_text().partition("[Service]")[2].partition("\n[")[0].splitlines()
    return [tuple(line.split("=", 1)) for line in lines if line and not line.startswith("#")]


def calls_of(group):
    """The system calls of a group of systemd, as `@system-service`, with those of the groups in it."""
    found = set()
    for line in analyze("syscall-filter", group).stdout.splitlines()[1:]:
        word = line.strip()
        if word.startswith("@"):
            found |= calls_of(word)
        elif word and not word.startswith("#"):
            found.add(word)
    return found


def allowed_calls():
    allowed = set()
    for key, value in settings():
        if key != "SystemCallFilter":
            continue
        words = value.removeprefix("~").split()
        calls = set().union(*(calls_of(word) if word.startswith("@") else {word} for word in words))
        allowed = allowed - calls if value.startswith("~") else allowed | calls
    return allowed


class Unit(unittest.TestCase):
    def setUp(self):
        held = tempfile.TemporaryDirectory()
        self.addCleanup(held.cleanup)
        self.folder = Path(held.name)

    def copy(self, **changed):
        """The unit with the program of this build; `changed`: other values, None: without that key."""
        text = UNIT.read_text().replace("/usr/local/bin/race", str(Path(PROGRAM).resolve()))
        for key, value in changed.items():
            text = re.sub(rf"^{key}=.*\n", "" if value is None else f"{key}={value}\n", text, flags=re.MULTILINE)
        path = self.folder / "race.service"
        path.write_text(text)
        return path

    def test_is_verified(self):
        out = analyze("verify", "--man=no", str(self.copy()))
        self.assertEqual((out.returncode, out.stdout, out.stderr), (0, "", ""))
        self.assertNotEqual(analyze("verify", "--man=no", str(self.copy(ProtectSystem="loose"))).stderr, "", "it sees a wrong value")

    def test_commands_on_its_data_are_units_with_its_user_and_folder(self):
        """As deploy/README.md has them; here no systemd runs them."""
        text = (PROJECT / "deploy/README.md").read_text().replace("\\\n", " ")
        words = re.search(r"^ +sudo systemd-run (.+)$", text, re.MULTILINE)[1].split()
        at = words.index("/usr/local/bin/race")
        known = subprocess.run(["systemd-run", "--help"], capture_output=True, text=True, timeout=TIMEOUT, check=True).stdout
        for option in words[:at]:
            self.assertIn(f" {option.split('=')[0]} ", known.replace("=", " "))
        properties = dict(word.removeprefix("--property=").split("=", 1) for word in words[:at] if word.startswith("--property="))
        unit = dict(settings())
        self.assertEqual(properties.pop("User"), UNIT.stem, "without User=, the name of the unit is its user's")
        self.assertNotIn("User", unit)
        for key in ("DynamicUser", "StateDirectory", "StateDirectoryMode", "UMask"):
            self.assertEqual(properties.pop(key), unit[key])
        self.assertEqual(properties, {})
        command = self.folder / "command.service"
        lines = [word.removeprefix("--property=") for word in words[:at] if word.startswith("--property=")]
        command.write_text("\n".join(["[Service]", *lines, f"ExecStart={Path(PROGRAM).resolve()} {' '.join(words[at + 1:])}", ""]))
        out = analyze("verify", "--man=no", str(command))
        self.assertEqual((out.returncode, out.stdout, out.stderr), (0, "", ""))
        self.assertEqual(words[-1], f"/var/lib/{unit['StateDirectory']}")
        added = subprocess.run([PROGRAM, *words[at + 1:-1], str(self.folder / "data")], input="an example password\n", capture_output=True,
                               text=True, timeout=TIMEOUT, check=False)
        self.assertEqual((added.returncode, added.stderr), (0, ""))

    def exposure(self, path):
        out = analyze("security", "--offline=true", str(path))
        return float(re.search(r"Overall exposure level for race.service: ([0-9.]+)", out.stdout)[1])

    def test_exposes_little(self):
        rating = self.exposure(self.copy())
        print(f"exposure {rating} of 10", flush=True)
        self.assertLessEqual(rating, MOST_EXPOSED)
        self.assertGreater(self.exposure(self.copy(PrivateUsers=None, CapabilityBoundingSet=None)), MOST_EXPOSED)

    def test_has_what_an_operator_counts_on(self):
        unit = dict(settings())
        for key, value in {"Type": "notify", "DynamicUser": "yes", "StateDirectory": "race", "NoNewPrivileges": "yes",
                           "ProtectSystem": "strict", "ProtectHome": "yes", "PrivateTmp": "yes", "PrivateDevices": "yes",
                           "CapabilityBoundingSet": "", "MemoryDenyWriteExecute": "yes", "Restart": "on-failure",
                           "KillSignal": "SIGTERM"}.items():
            self.assertEqual(unit.get(key), value, key)
        self.assertGreater(int(unit["TimeoutStopSec"]), 10)
        words = unit["ExecStart"].split()
        self.assertEqual(words[:4], ["/usr/local/bin/race", "serve", "--config", "/etc/race/race.conf"])

    def test_a_run_asks_the_kernel_for_nothing_else(self):
        """Everything that a server with a cell does is in the filter; nothing is writable and executable."""
        record = self.folder / "calls"
        under = (strace(), "-D", "-f", "-qq", "-o", str(record), "--signal=none")
        with Server("--demo", str(PROJECT / "deploy/demo"), "--lan-port", "0", under=under) as server:
            core = server.core(moving(speed=0.2))
            server.wait(core, lambda c: c["step"] > 0)
            server.ended(server.core(models.storing(), {"key": "a", "value": 1}))
            server.post("/backups", None, None, 201)
        text = record.read_text(errors="replace")
        used = set(re.findall(r"^\d+ +(?:<\.\.\. )?([a-z_0-9]+)(?:\(| resumed>)", text, re.MULTILINE))
        self.assertGreater(len(used), 30)
        as_root = {"fchown"} if os.geteuid() == 0 else set()  # SQLite gives files that it makes to the owner of the store
        self.assertEqual(used - allowed_calls() - as_root, set())
        self.assertNotIn("reboot", allowed_calls())
        executable = [line for line in text.splitlines() if re.search(r" (mmap|mprotect|pkey_mprotect)\(.*PROT_EXEC", line)]
        self.assertEqual([line for line in executable if "PROT_WRITE" in line or "mprotect(" in line], [])
        families = set(re.findall(r"socket\((AF_\w+)", text))
        self.assertLessEqual(families, set(dict(settings())["RestrictAddressFamilies"].split()))


class Installation(unittest.TestCase):
    def test_goes_below_a_folder_and_keeps_a_configuration(self):
        if not (PROJECT / "web/dist").is_dir() or not (PROJECT / "build/release/race").exists():
            self.skipTest("there is no build of the pages")
        with tempfile.TemporaryDirectory() as root:
            for _ in range(2):
                out = subprocess.run([PROJECT / "deploy/install_service", "--root", root], capture_output=True, text=True, timeout=60,
                                     check=False)
                self.assertEqual(out.returncode, 0, out.stderr)
                config = Path(root, "etc/race/race.conf")
                self.assertIn("\nweb = /usr/local/share/race/dist\n", config.read_text())
                config.write_text(config.read_text() + "# mine\n")
            self.assertEqual(config.read_text().count("# mine"), 2)
            self.assertTrue(Path(root, "etc/race/race.conf.new").is_file())
            self.assertTrue(Path(root, "etc/systemd/system/race.service").is_file())
            self.assertTrue(os.access(Path(root, "usr/local/bin/race"), os.X_OK))
            self.assertTrue(Path(root, "usr/local/share/race/demo/scene.json").is_file())
            self.assertTrue(Path(root, "usr/local/share/man/man1/race.1").read_text().startswith(".TH RACE 1"))
            self.assertIn("complete -F _race race", Path(root, "usr/local/share/bash-completion/completions/race").read_text())


class Container(unittest.TestCase):
    """Without a daemon: its instructions, the paths that it copies, its health check."""

    KNOWN = ("FROM", "WORKDIR", "ENV", "COPY", "RUN", "USER", "VOLUME", "EXPOSE", "STOPSIGNAL", "HEALTHCHECK", "ENTRYPOINT")

    def instructions(self):
        text = re.sub(r"^#.*\n", "", (PROJECT / "deploy/Dockerfile").read_text(), flags=re.MULTILINE)
        lines = [line for line in re.sub(r"\\\n\s*", " ", text).splitlines() if line.strip()]
        return [tuple(line.split(None, 1)) for line in lines]

    def test_is_of_instructions_that_are_known_and_copies_what_is_there(self):
        kept_out = [line for line in (PROJECT / ".dockerignore").read_text().splitlines() if line]
        for name, rest in self.instructions():
            self.assertIn(name, self.KNOWN)
            if name == "COPY" and "--from" not in rest:
                for source in rest.split()[:-1]:
                    self.assertTrue((PROJECT / source).exists(), source)
                    self.assertNotIn(source, kept_out)
            if name == "RUN":
                check = subprocess.run(["/bin/sh", "-n", "-c", rest], capture_output=True, text=True, timeout=TIMEOUT, check=False)
                self.assertEqual(check.returncode, 0, check.stderr)
        names = [name for name, _ in self.instructions()]
        self.assertEqual(names.count("FROM"), 2)
        rest = dict(self.instructions())
        self.assertEqual((rest["USER"], rest["VOLUME"]), ("race", "/data"))

    def test_its_health_check_tells_a_server_from_none(self):
        words = json.loads(dict(self.instructions())["HEALTHCHECK"].partition("CMD ")[2])
        with Server() as server:
            words[-1] = words[-1].replace("8080", str(server.port))
            self.assertEqual(subprocess.run(words, timeout=TIMEOUT, check=False).returncode, 0)
        out = subprocess.run(words, stderr=subprocess.DEVNULL, timeout=TIMEOUT, check=False)
        self.assertNotEqual(out.returncode, 0)

    def test_its_options_are_those_of_the_program(self):
        words = json.loads(dict(self.instructions())["ENTRYPOINT"])
        self.assertEqual(words[:2], ["/usr/local/bin/race", "serve"])
        with tempfile.TemporaryDirectory() as data:
            places = {"/usr/local/share/race/demo": str(PROJECT / "deploy/demo"), "/etc/race/race.conf": str(PROJECT / "deploy/race.conf"),
                      "/data": data}
            out = subprocess.run([PROGRAM, *(places.get(word, word) for word in words[1:]), "--check-config"], capture_output=True,
                                 text=True, timeout=TIMEOUT, check=False)
            self.assertEqual((out.returncode, out.stderr), (0, ""))


if __name__ == "__main__":
    unittest.main()
