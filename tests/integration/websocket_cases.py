"""Cases of RFC 6455, made of small tables: what a client sends after the handshake, and what a server may say to it, by section."""
import json
from collections.abc import Callable
from dataclasses import dataclass

from raw_websocket import BINARY, CLOSE, CONTINUATION, PING, PONG, TEXT, Said, close, fragments, frame

MOST = 65536  # bytes of a message (asyncapi.yaml)
KINDS = {"text": TEXT, "binary": BINARY, "ping": PING, "pong": PONG, "close": CLOSE, "continuation": CONTINUATION}
NOT_UTF8 = {
    "a byte that is none": b"\xff", "a second byte alone": b"\x80", "two of them": b"\x80\xbf", "no second byte": b"\xc3",
    "a wrong second byte": b"\xc3(", "no third byte": b"\xe2\x82", "no fourth byte": b"\xf0\x9f\xa4", "overlong slash": b"\xc0\xaf",
    "overlong NUL": b"\xc0\x80", "overlong of three": b"\xe0\x80\xaf", "overlong of four": b"\xf0\x80\x80\xaf",
    "a surrogate": b"\xed\xa0\x80", "a pair of them": b"\xed\xa0\xbd\xed\xb8\x80", "beyond U+10FFFF": b"\xf4\x90\x80\x80",
    "far beyond": b"\xf7\xbf\xbf\xbf", "five bytes": b"\xf8\x88\x80\x80\x80", "six bytes": b"\xfc\x84\x80\x80\x80\x80",
    "UTF-16": b"\xfe\xff\x00x"}
CODES = {
    "fail": (0, 1, 500, 999, 1004, 1005, 1006, 1015, 5000, 5001, 32768, 65535),
    "are none yet": (1012, 1013, 1014, 1016, 1100, 1999, 2000, 2999),
    "are echoed": (1000, 1001, 1002, 1003, 1007, 1008, 1009, 1010, 1011, 3000, 3001, 3999, 4000, 4999)}


@dataclass
class Case:
    section: str
    name: str
    sent: list  # pieces
    allows: Callable[[Said], bool]
    ends: bool = True  # the server ends the connection; else it is asked something after it
    pause: float = 0  # [s] after each piece
    stream_only: bool = False  # a message of the stream is in it

    def __str__(self):
        return f"{self.section}: {self.name}"


def message(name):
    """A message of the stream; the answer is on the channel of that name."""
    return json.dumps({"type": "subscribe", "channel": name}, ensure_ascii=False).encode()


# ---- What is allowed. `maybe`: what comes before may be answered, or not any more.

def fails(*codes, maybe=()):
    """_Fail the WebSocket Connection_ (7.1.7): it ends; before that there SHOULD be a close frame with one of these codes."""
    def allows(said):
        rest = [event for event in said.events if event not in maybe]
        return said.ended and rest in [[], *([("close", code)] for code in codes)]
    return allows


def closes(*codes, maybe=()):
    """The close handshake: a close frame with one of these codes (None: without one), and the end (5.5.1)."""
    def allows(said):
        rest = [event for event in said.events if event not in maybe]
        return said.ended and rest in [[("close", code)] for code in codes]
    return allows


def says(*events):
    return lambda said: said.events == list(events) and not said.ended


def pongs(*payloads):
    """5.5.3: a pong for each ping, or for the last of those that have come."""
    def allows(said):
        got, wanted = [which for what, which in said.events if what == "pong"], iter(payloads)
        return len(got) == len(said.events) and got[-1:] == [payloads[-1]] and all(each in wanted for each in got) and not said.ended
    return allows


# ---- The cases, by what they are about.

def of_masks():
    for name, opcode in KINDS.items():
        for payload in (b"", b"{}"):
            yield Case("5.1", f"a {name} frame of {len(payload)} bytes is not masked", [frame(opcode, payload, mask=None)], fails(1002))
    for mask in (bytes(4), b"\xff" * 4, b"\0\0\0\1", b"\x80\0\0\0"):
        yield Case("5.3", f"masked with {mask.hex()}", [frame(PING, b"masked", mask=mask)], says(("pong", b"masked")), ends=False)


def of_reserved_bits():
    for bits in range(1, 8):
        for name in ("text", "ping", "close"):
            yield Case("5.2", f"reserved bits {bits:03b} of a {name} frame", [frame(KINDS[name], b"", reserved=bits)], fails(1002))
        sent = [frame(TEXT, b"{", fin=False), frame(CONTINUATION, b"}", reserved=bits)]
        yield Case("5.2", f"reserved bits {bits:03b} of a continuation", sent, fails(1002))


def of_opcodes():
    for opcode in (3, 4, 5, 6, 7, 11, 12, 13, 14, 15):
        yield Case("5.2", f"opcode {opcode}", [frame(opcode, b"x")], fails(1002))
        yield Case("5.2", f"opcode {opcode}, not the last frame", [frame(opcode, b"", fin=False)], fails(1002))
        yield Case("5.2", f"opcode {opcode} between fragments", [frame(TEXT, b"{", fin=False), frame(opcode)], fails(1002))


def of_control_frames():
    for name in ("ping", "pong", "close"):
        for size in (126, 127, 65535, 65536):
            payload = b"\x03\xe8" + b"x" * (size - 2)
            yield Case("5.5", f"a {name} of {size} bytes", [frame(KINDS[name], payload)], fails(1002))
        yield Case("5.5", f"a {name} that is fragmented", [frame(KINDS[name], fin=False), frame(CONTINUATION)], fails(1002))
        sent = [frame(TEXT, b"{", fin=False), frame(KINDS[name], fin=False)]
        yield Case("5.5", f"a {name} that is fragmented, between fragments", sent, fails(1002))


def of_close_frames():
    for code in CODES["fail"]:
        yield Case("7.4", f"the code {code}, which is none", [close(code)], fails(1002))
    for code in CODES["are none yet"]:  # 7.4.2 keeps them for later; some have been registered since
        yield Case("7.4.2", f"the code {code}, which this version does not have", [close(code)], fails(1002, code))
    for code in CODES["are echoed"]:
        yield Case("5.5.1", f"the code {code}", [close(code)], closes(code))
    yield Case("5.5.1", "no code", [close()], closes(None, 1000))
    yield Case("5.5.1", "half a code", [frame(CLOSE, b"\x03")], fails(1002))
    for reason in (b"x", b"x" * 123, "\u20ac\U0001f916".encode(), b"\0"):
        yield Case("5.5.1", f"a reason {reason[:20]}", [close(1000, reason)], closes(1000))
    for name, wrong in NOT_UTF8.items():
        yield Case("5.5.1", f"a reason that is no UTF-8: {name}", [close(1000, b"x" + wrong)], fails(1007, 1002))
    for name, after in (("a ping", frame(PING, b"x")), ("a second close frame", close(1001)), ("what is no frame", b"\xff" * 20)):
        yield Case("1.4", f"{name} after a close frame counts for nothing", [close(1000) + after], closes(1000))
    yield Case("1.4", "a message after a close frame counts for nothing", [close(1000) + frame(TEXT, message("none/a"))], closes(1000))
    yield Case("5.4", "a close frame between fragments", [frame(TEXT, b"{", fin=False), close(1000)], closes(1000))
    before = frame(TEXT, message("none/b")) + close(1001)
    yield Case("5.5.1", "a message right before it", [before], closes(1001, maybe=[("message", "none/b")]), stream_only=True)
    yield Case("5.5.3", "a ping right before it", [frame(PING, b"x") + close(1001)], closes(1001, maybe=[("pong", b"x")]))


def of_utf8():
    for name, wrong in NOT_UTF8.items():
        yield Case("8.1", f"no UTF-8: {name}", [frame(TEXT, b'"' + wrong)], fails(1007))
        text = b'"' + wrong + b'"'
        yield Case("8.1", f"no UTF-8, in pieces of a byte: {name}", [fragments(text, [1] * (len(text) - 1))], fails(1007))
    for text in ("\u00e9", "\u20ac", "\U0001f916", "\u0080\u07ff\u0800\uffff", "\U00010000\U0010ffff", "\ufffe", "\ud7ff\ue000"):
        name = f"none/{text}"
        yield Case("8.1", f"{text!a} in one frame", [frame(TEXT, message(name))], says(("message", name)), ends=False, stream_only=True)
        sent = [fragments(message(name), [1] * (len(message(name)) - 1))]
        yield Case("5.4", f"{text!a} in pieces of a byte", sent, says(("message", name)), ends=False, stream_only=True)


def of_fragments():
    begun = frame(TEXT, b"{", fin=False)
    for name, sent in (
            ("a continuation of nothing", frame(CONTINUATION, b"{}")), ("an empty one", frame(CONTINUATION)),
            ("one that goes on", frame(CONTINUATION, fin=False)), ("a text within a message", begun + frame(TEXT, b"}")),
            ("a binary message within one", begun + frame(BINARY, b"}")),
            ("a text that goes on within one", begun + frame(TEXT, b"}", fin=False)),
            ("a text within an empty one", frame(TEXT, fin=False) + frame(TEXT, b"}"))):
        yield Case("5.4", name, [sent], fails(1002))
    text = message("none/f")
    sent = [frame(TEXT, text), frame(CONTINUATION, b"x")]
    yield Case("5.4", "a continuation of a message that is whole", sent, fails(1002, maybe=[("message", "none/f")]), stream_only=True)
    ping, pong, answer = frame(PING, b"p"), frame(PONG, b"nobody has asked"), ("message", "none/f")
    good = {"two": fragments(text, [5]), "three": fragments(text, [5, 5]), "of a byte": fragments(text, [1] * (len(text) - 1)),
            "the first is empty": fragments(text, [0]), "the last is empty": fragments(text, [len(text)]),
            "empty ones": fragments(text, [0, 3, 0, 0, 4, 0]), "a hundred empty ones": fragments(text, [0] * 100),
            "with a pong between": fragments(text, [3, 4, 5], between=pong)}
    for name, sent in good.items():
        yield Case("5.4", f"fragments: {name}", [sent], says(answer), ends=False, stream_only=True)
    yield Case("5.4", "a ping between fragments is answered at once", [fragments(text, [9], between=ping)], says(("pong", b"p"), answer),
               ends=False, stream_only=True)
    many = lambda said: pongs(*[b"p"] * 9)(Said(said.events[:-1], said.ended)) and said.events[-1:] == [answer]
    yield Case("5.4", "pings between many", [fragments(text, [2] * 9, between=ping)], many, ends=False, stream_only=True)
    yield Case("5.4", "an empty message in three frames is one", [fragments(b"", [0, 0])], says(("message", "")), ends=False,
               stream_only=True)


def of_lengths():
    for form, sizes in ((2, (0, 5, 125)), (8, (0, 5, 125, 126, 65535))):
        for size in sizes:
            yield Case("5.2", f"{size} bytes as a length of {form} bytes", [frame(TEXT, b" " * size, form=form)], fails(1002))
    for form in (2, 8):
        yield Case("5.2", f"a ping with a length of {form} bytes", [frame(PING, b"p", form=form)], fails(1002))
    for length in (1 << 63, (1 << 63) + 5, (1 << 64) - 1):  # the highest bit MUST be 0; or it is too large anyway
        yield Case("5.2", f"a length of {length:x}", [frame(TEXT, form=8, length=length)], fails(1002, 1009))
    for length in (MOST + 1, 1 << 20, 1 << 31, 1 << 32, (1 << 63) - 1):
        yield Case("10.4", f"a message of {length} bytes", [frame(TEXT, form=8, length=length)], fails(1009), stream_only=True)
    half = [frame(TEXT, b" " * (MOST // 2), fin=False), frame(CONTINUATION, b" " * (MOST // 2), fin=False)]
    yield Case("10.4", "fragments of more than that", [*half, frame(CONTINUATION, b" ")], fails(1009), stream_only=True)
    for size in (125, 126, 127, 65535, MOST):
        text = message("none/l").ljust(size)
        yield Case("5.2", f"a message of {size} bytes", [frame(TEXT, text)], says(("message", "none/l")), ends=False, stream_only=True)
    yield Case("10.4", "fragments of just that", [*half, frame(CONTINUATION)], says(("message", "")), ends=False, stream_only=True)


def of_pings():
    for payload in (b"", b"p", b"\0", bytes(range(125)), b"\xff" * 124, "\u20ac".encode(), b"\x03\xe8"):
        yield Case("5.5.3", f"a ping of {len(payload)} bytes {payload[:3]}", [frame(PING, payload)], says(("pong", payload)), ends=False)
    payloads = [b"%d" % number for number in range(20)]
    yield Case("5.5.3", "many pings", [b"".join(frame(PING, each) for each in payloads)], pongs(*payloads), ends=False)
    for payload in (b"", b"nobody has asked", b"x" * 125):
        yield Case("5.5.3", f"a pong of {len(payload)} bytes that nobody has asked for", [frame(PONG, payload)], says(), ends=False)


def of_binary_messages():
    for name, sent in (("empty", frame(BINARY)), ("of bytes", frame(BINARY, b"\xff\0")),
                       ("that could be a text", frame(BINARY, message("none/x"))),
                       ("in fragments", fragments(b"\xff" * 9, [3, 3], opcode=BINARY))):
        yield Case("7.4.1", f"a binary message {name}", [sent], fails(1003), stream_only=True)


def of_slow_clients():
    """Byte by byte, with time between: a frame may come in any pieces (TCP has none)."""
    in_bytes = lambda data: [data[place:place + 1] for place in range(len(data))]
    text, answer = message("none/s"), ("message", "none/s")
    good = {"a message": frame(TEXT, text), "fragments": fragments(text, [4, 4]), "a length of two bytes": frame(TEXT, text.ljust(130))}
    for name, sent in good.items():
        yield Case("5.2", f"{name}, byte by byte", in_bytes(sent), says(answer), ends=False, pause=0.001, stream_only=True)
    yield Case("5.5.3", "a ping, byte by byte", in_bytes(frame(PING, b"slow")), says(("pong", b"slow")), ends=False, pause=0.01)
    yield Case("5.5.1", "a close frame, byte by byte", in_bytes(close(1000, b"slow")), closes(1000), pause=0.01)
    yield Case("5.1", "a frame that is not masked, byte by byte", in_bytes(frame(PING, b"slow", mask=None)), fails(1002), pause=0.01)
    yield Case("8.1", "no UTF-8, byte by byte", in_bytes(frame(TEXT, b'"\xf0\x9f\xff')), fails(1007), pause=0.01)


def cases():
    makers = (of_masks, of_reserved_bits, of_opcodes, of_control_frames, of_close_frames, of_utf8, of_fragments, of_lengths, of_pings,
              of_binary_messages, of_slow_clients)
    return [case for maker in makers for case in maker()]
