"""Handshakes of RFC 6455, right and wrong, and the statuses that a server may answer, by section."""
from raw_websocket import HEADERS, KEY

NO_HANDSHAKE = (400, 426)  # 4.2.2: an appropriate error code, such as 400
OK = (101,)
OTHER_KEY = "AAAAAAAAAAAAAAAAAAAAAA=="


def changed(**changes):
    """The headers of a handshake with others in place of some, written with underscores; None: without it; a list: several times."""
    headers = dict(HEADERS) | {name.replace("_", "-"): value for name, value in changes.items()}
    listed = {name: value if isinstance(value, list) else [value] for name, value in headers.items() if value is not None}
    return [(name, value) for name, values in listed.items() for value in values]


# (section, name, method, version, headers, statuses)
GOOD = [("4.2.1", name, "GET", "HTTP/1.1", headers, OK) for name, headers in (
    ("as it should be", changed()), ("names in lower case", [(name.lower(), value) for name, value in changed()]),
    ("names in upper case", [(name.upper(), value) for name, value in changed()]), ("the headers in another order", changed()[::-1]),
    ("websocket in another case", changed(Upgrade="WebSocket")), ("upgrade in another case", changed(Connection="upgrade")),
    ("upgrade among others", changed(Connection="keep-alive, Upgrade")), ("upgrade as the first of some", changed(Connection="Upgrade,x")),
    ("spaces around the key", changed(Sec_WebSocket_Key=f" \t{KEY} ")), ("another key", changed(Sec_WebSocket_Key=OTHER_KEY)),
    ("a protocol", changed(Sec_WebSocket_Protocol="chat, superchat")),
    ("an unknown extension", changed(Sec_WebSocket_Extensions="x-race; a=1")),
    ("headers that are none of it", changed(X_Other="1", Cookie="a=b")), ("an own origin", changed(Origin="http://127.0.0.1:PORT")))]
# A server may go on with HTTP (RFC 9110, 7.8), for which these are no upgrade.
GOOD += [("RFC 9110, 7.8", name, "GET", "HTTP/1.1", headers, (*OK, 426)) for name, headers in (
    ("upgrade in a second line", changed(Connection=["keep-alive", "Upgrade"])),
    ("websocket among others", changed(Upgrade="example/1, websocket")))]
BAD = [(section, name, "GET", "HTTP/1.1", headers, statuses) for section, name, headers, statuses in (
    ("4.2.1", "no key", changed(Sec_WebSocket_Key=None), NO_HANDSHAKE),
    ("11.3.1", "two keys", changed(Sec_WebSocket_Key=[KEY, OTHER_KEY]), NO_HANDSHAKE),
    ("4.2.1", "no version", changed(Sec_WebSocket_Version=None), NO_HANDSHAKE),
    ("4.2.1", "an empty version", changed(Sec_WebSocket_Version=""), NO_HANDSHAKE),
    ("4.2.1", "no connection", changed(Connection=None), NO_HANDSHAKE),
    ("4.2.1", "connection: close", changed(Connection="close"), NO_HANDSHAKE),
    ("4.2.1", "another option", changed(Connection="Upgrades"), NO_HANDSHAKE), ("4.2.1", "no upgrade", changed(Upgrade=None), NO_HANDSHAKE),
    ("4.2.1", "another upgrade", changed(Upgrade="h2c"), NO_HANDSHAKE),
    ("4.2.1", "nearly websocket", changed(Upgrade="websockets"), NO_HANDSHAKE),
    ("4.2.1", "no host", changed(Host=None), (400,)), ("4.2.1", "two hosts", changed(Host=["127.0.0.1:PORT"] * 2), (400,)),
    ("4.2.2", "a foreign origin", changed(Origin="http://evil.example"), (403,)))]
# A key that violates the grammar (4.3) MUST be refused (4.2.1); what is base64 need not be decoded (4.2.2), so its length is free.
BAD += [("4.3", f"the key {key!r}", "GET", "HTTP/1.1", changed(Sec_WebSocket_Key=key), NO_HANDSHAKE)
        for key in ("", "abc", "AAAAA", "!" * 24, "A" * 22, "A" * 21 + "===", "=" * 24, "A" * 11 + " " + "A" * 10 + "==", "\u00e9" * 12)]
BAD += [("4.2.2", f"a key of {len(key)} characters", "GET", "HTTP/1.1", changed(Sec_WebSocket_Key=key), OK + NO_HANDSHAKE)
        for key in ("AAAA", "A" * 20, "A" * 23 + "=", "A" * 24, "x" * 1000)]
BAD += [("4.4", f"the version {version}", "GET", "HTTP/1.1", changed(Sec_WebSocket_Version=version), NO_HANDSHAKE)
        for version in ("0", "7", "8", "12", "14", "25", "255")]
BAD += [("4.3", f"the version {version!r}, which is none", "GET", "HTTP/1.1", changed(Sec_WebSocket_Version=version), NO_HANDSHAKE)
        for version in ("256", "013", "13.0", "+13", "-13", "x", "8, 13", "13 13")]
BAD += [("4.2.1", f"the method {method}", method, "HTTP/1.1", changed(), (400, 405, 426, 501))
        for method in ("POST", "PUT", "DELETE", "OPTIONS", "PATCH", "get")]
BAD += [("4.2.1", f"the version of HTTP {version!r}", "GET", version, changed(), (400, 426, 505))
        for version in ("HTTP/1.0", "HTTP/0.9", "HTTP/2.0", "http/1.1", "HTTP/1.1x", "HTP/1.1", "")]
