"""The plain client from the asyncio client: the same text without what waits. Only their sockets (net.py) are written twice."""
import re

WORDS = [(r"\bAwaitable\[(\w+)\]", r"\1"), (r"\bAwaitable, ", ""),
         (r"\b(?:async )?for (\w+) in (.+):\n +yield \1\n", r"yield from \2\n"),
         (r"\basync (def|with|for)\b", r"\1"), (r"\(await (.+\))\)\[", r"\1["), (r"\bawait ", ""),
         (r"\bAsync(?=[A-Z])", ""), (r"\b__a(enter|exit|iter|next)__\b", r"__\1__"),
         (r"\bStopAsyncIteration\b", "StopIteration"), (r"\baio\b", "plain"), (r"\basyncio client\b", "plain client")]
HEADER = "# Made from ../aio/{name} by generate/main.py.\n"


def plain_text(name: str, text: str) -> str:
    """A module of the plain client, from the module of that name of the asyncio client."""
    for pattern, replacement in WORDS:
        text = re.sub(pattern, replacement, text)
    return HEADER.format(name=name) + text
