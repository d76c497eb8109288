"""Servers with accounts: made on the command line, as a user makes them before the first start."""
import subprocess
import tempfile

from client import PROGRAM, TIMEOUT, Server

PASSWORD = "correct horse battery"
ROLES = ("observer", "operator", "developer", "admin")


def race_account(data, *words, text=PASSWORD + "\n"):
    """`race account` on a data folder; its output."""
    return subprocess.run([PROGRAM, "account", *words, "--data", data], input=text, capture_output=True, text=True,
                          timeout=TIMEOUT, check=True).stdout


def folder_with_accounts():
    """A new data folder with an account of each role, named as its role, and of two processes."""
    data = tempfile.mkdtemp(prefix="race-test-")
    for role in reversed(ROLES):  # the first is an admin
        race_account(data, "add", role, "--role", role)
    race_account(data, "add", "speaker", "--role", "process", "--groups", "audio")
    return data


def token_of(data, account):
    """A token of the account, from the command line: it costs no password."""
    return race_account(data, "token", account).strip()


class AccountServer(Server):
    """A server of folder_with_accounts(); `tokens` has one of each account. Its requests are those of the admin."""

    def __init__(self, *options, **how):
        data = folder_with_accounts()
        self.tokens = {account: token_of(data, account) for account in (*ROLES, "speaker")}
        super().__init__(*options, data=data, **how)
        self.own = True
        self.token = self.tokens["admin"]

    def ask(self, account, method, path, body=None):
        """The status of a request of an account; None: of nobody."""
        authorization = {} if account is None else {"Authorization": f"Bearer {self.tokens[account]}"}
        return self.request(method, path, body, {"Authorization": "", **authorization})[0]
