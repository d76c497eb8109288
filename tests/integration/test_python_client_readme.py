"""The how-to of api/python/README.md: its blocks, run one after the other against the demo, print what the page says."""
import contextlib
import io
import re
import unittest

from client import PROJECT, Server
from python_clients import LIBRARY, race_client

BLOCK = re.compile(r"^```(python|text)\n(.*?)^```$", re.MULTILINE | re.DOTALL)


class Readme(unittest.TestCase):
    def test_blocks_print_what_the_page_says(self):
        blocks = BLOCK.findall((LIBRARY / "README.md").read_text())
        self.assertGreater(len(blocks), 15)
        names = {"__name__": "readme"}
        with Server("--demo", str(PROJECT / "deploy/demo")) as server:
            said = ""
            for kind, text in blocks:
                with self.subTest(text):
                    if kind == "text":
                        self.assertEqual(said, text)
                        continue
                    output = io.StringIO()
                    with contextlib.redirect_stdout(output):
                        exec(text.replace("http://127.0.0.1:8080", f"http://127.0.0.1:{server.port}"), names)
                    said = output.getvalue()

    def test_the_example_of_the_package_is_the_demo(self):
        example = re.search(r"^    from race_client.*?\n\n(?=`)", race_client.__doc__, re.MULTILINE | re.DOTALL).group(0)
        code = "\n".join(line[4:] for line in example.splitlines())
        with Server("--demo", str(PROJECT / "deploy/demo")) as server:
            output = io.StringIO()
            with contextlib.redirect_stdout(output):
                exec(code.replace("http://127.0.0.1:8080", f"http://127.0.0.1:{server.port}"), {})
        self.assertIn("actual_width", output.getvalue())


if __name__ == "__main__":
    unittest.main()
