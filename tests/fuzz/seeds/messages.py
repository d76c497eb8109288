"""What connections say: requests, messages of the stream, and those of a process of components (a message a line)."""
from seeds.project import EXAMPLES, compact, examples, read

HOST = "Host: localhost:8080\r\n"
COMPOUND = [
    {"kind": "rename", "id": "a", "name": "Z"}, {"kind": "rename_service", "key": "t", "name": "u"},
    {"kind": "connect", "from": "adone", "to": "B"}, {"kind": "disconnect", "barrier": "c", "state": "A"},
    {"kind": "group", "ids": ["a", "b"], "name": "G"}, {"kind": "ungroup", "id": "b"}, {"kind": "duplicate", "id": "a"},
    {"kind": "extract", "id": "b", "name": "E"},
]
# Of the display, question and sound that stream.cpp has there.
DISPLAY = [
    {"type": "display", "name": "main", "sound": True}, {"type": "press", "button": "Stop"},
    {"type": "display", "name": "main", "place": "gripper"},
    {"type": "answer", "question": 2, "answer": 0.5}, {"type": "played", "sound": 3},
    {"type": "subscribe", "channel": "core/1/state"}, {"type": "subscribe", "channel": "cell/pose", "since": 1},
    {"type": "unsubscribe", "channel": "core/1/state"},
]
# Of the lamp, the world and the screens that component.cpp has there, in answer to its calls and commands.
LAMP = [
    {"type": "transition", "key": "lamp", "id": "t2", "call": 1}, {"type": "transition", "key": "lamp", "id": "t3"},
    {"type": "result", "key": "lamp", "call": 1, "value": None},
    {"type": "error", "key": "lamp", "call": 2, "error": {"code": "burnt"}}, {"type": "reject", "key": "lamp", "call": 3},
    {"type": "event", "key": "lamp", "name": "lit", "data": 1}, {"type": "log", "key": "lamp", "text": "on"},
    {"type": "subscribe", "key": "lamp", "service": "camera", "flow": "images", "on": True},
]
WORLD = [
    {"type": "pose", "pose": {"time": 1.5, "joints": {"j": 0.5}, "bodies": {}}}, {"type": "ready", "number": 1},
    {"type": "done", "number": 1, "person": {"hands": [], "absent": ["part"]}}, {"type": "ready", "number": 2},
    {"type": "failed", "number": 2, "error": {"path": "hand", "code": "not_found", "message": "none"}},
    {"type": "pong", "number": 1},
]
SCREENS = [
    {"type": "request", "key": "display", "number": 1, "function": "ask",
     "arguments": {"text": "Go on?", "buttons": ["Yes"], "display": "all"}},
    {"type": "request", "key": "display", "number": 2, "function": "take", "arguments": {}},
    {"type": "request", "key": "display", "number": 5, "function": "show_progress",
     "arguments": {"text": "Calibrating", "progress": 0.4, "display": "@gripper"}},
    {"type": "request", "key": "audio", "number": 3, "function": "play", "arguments": {"sound": "done"}},
    {"type": "request", "key": "audio", "number": 4, "function": "playback", "arguments": {}},
]
TOLD = [
    {"type": "call", "key": "lamp", "call": 1, "operation": "on", "args": [], "kwargs": {}, "time": 0.5},
    {"type": "act", "number": 1, "act": {"hand": "h"}, "time": 0.5}, {"type": "ping", "number": 1, "time": 2.5},
    {"type": "wanted", "key": "lamp", "flow": "f", "on": True, "time": 1.0},
    {"type": "limit_speed", "key": "lamp", "tool_speed": 0.25, "time": 1.0},
]
PACKETS = [
    '#{"type":"publish","key":"lamp","flow":"f","time":1.5,"header":{"width":1}}\tbytes',
    '#{"type":"packet","key":"lamp","service":"camera","flow":"images","time":1.5,"header":{}}\tbytes',
]


def lines(messages):
    return "\n".join(compact(message) for message in messages)


def requests():
    """Bytes of connections."""
    body = compact(read(EXAMPLES / "core_create.pick.json"))
    content = f"Content-Type: application/json\r\nContent-Length: {len(body)}\r\n\r\n{body}"
    coding = 'Accept-Encoding: gzip;q=0.5, br, *;q=0\r\nIf-None-Match: W/"3", *\r\n'
    upgrade = ("Upgrade: websocket\r\nConnection: upgrade\r\nSec-WebSocket-Version: 13\r\n"
               "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n")
    return [
        f"GET /api/v1/cores?from=1&x=%41+b HTTP/1.1\r\n{HOST}\r\n", f"GET / HTTP/1.1\r\n{HOST}{coding}\r\n" * 2,
        f"POST /api/v1/cores HTTP/1.1\r\n{HOST}Origin: http://localhost:8080\r\n{content}",
        f'POST /api/v1/runs HTTP/1.1\r\n{HOST}If-Match: "3"\r\n{content}'
        f"GET /api/v1/health HTTP/1.1\r\n{HOST}Connection: close\r\n\r\n",
        f"POST /a HTTP/1.1\r\n{HOST}Transfer-Encoding: chunked\r\n\r\n3\r\nabc\r\n0\r\n\r\n",
        f"PUT /api/v1/documents/pick HTTP/1.1\r\n{HOST}Expect: 100-continue\r\n{content}",
        f"GET /api/v1/stream HTTP/1.1\r\n{HOST}{upgrade}\r\n",
        f"HEAD /index.html HTTP/1.0\r\n{HOST}Connection: keep-alive\r\n\r\n",
        "GET http://localhost:8080/ HTTP/1.1\r\n\r\n",
    ]


def stream_messages():
    said = examples("stream_request.*.json")
    made = [each["edit"] for each in examples("edits/*.json") if "edit" in each]
    made += [{"compound": each} for each in COMPOUND] + [{"undo": True}]
    edits = [{"type": "edit", "document": "pick", "request": "c-1", "revision": 1, **each} for each in made]
    return [*map(compact, said), lines(said), *map(compact, edits), lines(DISPLAY)]


def component_messages():
    said, told = examples("component_request.*.json"), examples("component_message.*.json")
    talks = ["!lamp\n" + lines(LAMP), "!lamp\n" + lines(WORLD), "!screens\n" + lines(SCREENS), lines(TOLD), lines(told),
             lines(said), *PACKETS, "!lamp\n" + PACKETS[0]]
    return [*talks, *map(compact, said), *("!lamp\n" + compact(each) for each in [*LAMP, *WORLD])]
