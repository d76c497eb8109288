"""The conversations of api/conversations, held by the Python client library: by the plain client and by the asyncio client."""
import unittest

from conversations import SERVERS, Conversation, all_conversations
from python_clients import KINDS


def conversation_test(connect, conversation):
    """A test that holds a conversation by one kind of client."""
    def test(self):
        server = SERVERS[conversation.get("server", "plain")]()
        self.addCleanup(server.stop)

        def client_of(account):
            client = connect(f"http://127.0.0.1:{server.port}", token=account and server.tokens[account])
            self.addCleanup(client.close)
            return client

        Conversation(client_of).hold(conversation["steps"])

    return test


for file, each in all_conversations():
    for kind, connect in KINDS.items():
        name = f"{file.capitalize()}_{kind}"
        case = globals().setdefault(name, type(name, (unittest.TestCase,), {"__module__": __name__}))
        setattr(case, f"test_{each['title'].replace(' ', '_')}", conversation_test(connect, each))


if __name__ == "__main__":
    unittest.main()
