"""The base of tests whose server ends, or is killed, and begins again on the same data folder."""
import shutil
import tempfile
import unittest

from client import Server


class ServerCase(unittest.TestCase):
    """Each test has a server (`self.server`) with a data folder of its own (`self.data`)."""

    def setUp(self):
        self.data = tempfile.mkdtemp(prefix="race-test-")
        self.server = Server(data=self.data)

    def tearDown(self):
        self.server.stop()
        shutil.rmtree(self.data)

    def restart(self):
        """SIGTERM, and another server on the same folder."""
        self.server.stop()
        self.server = Server(data=self.data)

    def kill(self):
        """SIGKILL, and another server on the same folder."""
        self.server.kill()
        self.server = Server(data=self.data)
