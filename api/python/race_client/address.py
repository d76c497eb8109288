"""Where a server is, and how it is known."""
import ipaddress
import os
import re
import ssl
from dataclasses import dataclass
from urllib.parse import urlsplit

PORTS = {"http": 80, "https": 443}


@dataclass(frozen=True)
class Address:
    """Host and port of a server; `tls` is the context of its certificate, None without TLS."""

    host: str
    port: int
    tls: ssl.SSLContext | None

    @classmethod
    def parse(cls, url: str, ca_file: str | os.PathLike[str] | None = None) -> "Address":
        """Of `http://HOST:PORT` or `https://HOST:PORT`. ValueError: it is none, or http to another machine, or a wrong `ca_file`.

        `ca_file` is a PEM file with the authority of an https server (`tls/ca.pem` of its data folder); without it, those that this
        system trusts. A server of RACE speaks http on its own machine alone; to send a token further would show it to the network.
        """
        parts = urlsplit(url)
        more = parts.username or parts.path.strip("/") or parts.query or parts.fragment
        if parts.scheme not in PORTS or not parts.hostname or more:
            raise ValueError(f"`{url}` is no http://HOST:PORT or https://HOST:PORT")
        if parts.scheme == "http" and not is_own_machine(parts.hostname):
            raise ValueError(f"`{url}`: another machine is reached by https alone")
        return cls(parts.hostname, parts.port or PORTS[parts.scheme], tls_context(ca_file) if parts.scheme == "https" else None)

    @property
    def scheme(self) -> str:
        return "https" if self.tls else "http"

    @property
    def authority(self) -> str:
        """HOST:PORT as the header Host has it."""
        host = f"[{self.host}]" if ":" in self.host else self.host
        return host if self.port == PORTS[self.scheme] else f"{host}:{self.port}"

    def __str__(self) -> str:
        return f"{self.scheme}://{self.authority}"


def is_own_machine(host: str) -> bool:
    """Whether a host name is this machine's own."""
    try:
        return ipaddress.ip_address(host).is_loopback
    except ValueError:
        return host == "localhost" or host.endswith(".localhost")


def tls_context(ca_file: str | os.PathLike[str] | None) -> ssl.SSLContext:
    """Who is trusted: the authority of the file, or those of the system."""
    try:
        return ssl.create_default_context(cafile=ca_file)
    except ssl.SSLError:
        raise ValueError(f"{os.fspath(ca_file or '')} has no certificate of an authority") from None
    except OSError as error:
        raise ValueError(f"{os.fspath(ca_file or '')} cannot be read: {error.strerror or error}") from None


def checked_token(token: str | None) -> str | None:
    """The token, which goes into a header. ValueError: it has other characters than a token (RFC 6750)."""
    if token is not None and not re.fullmatch(r"[A-Za-z0-9._~+/-]+=*", token):
        raise ValueError("the token has characters that no token has")
    return token
