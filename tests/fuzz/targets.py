"""The fuzz targets: how long an input is, its seeds, and the words of its dictionary."""
from collections import namedtuple

from seeds import words
from seeds.journals import journals, run_files
from seeds.messages import component_messages, requests, stream_messages
from seeds.texts import codes, documents, robots

Target = namedtuple("Target", "most seeds words")  # bytes; functions that make them

TARGETS = {
    "document": Target(8192, documents, lambda: words.of_schemas("document", "state", "type", "service") | words.of_code()),
    "language": Target(1024, codes, words.of_code),
    "http": Target(4096, requests, words.of_requests),
    "stream": Target(4096, stream_messages, lambda: words.of_schemas("stream_request", "edit_request", "edit", "state") | {
        "core/1/state", "cell/pose", "display/main"}),
    "component": Target(4096, component_messages, lambda: words.of_schemas("component_request", "component_message") | {
        "!lamp", "!screens", "#{", "\n"}),
    "journal": Target(8192, journals, lambda: words.of_schemas("journal", "input", "native", "force", "edit", "state")),
    "run_file": Target(16384, run_files, lambda: words.of_schemas("run_file", "run", "journal", "input", "cell_pose")),
    "urdf": Target(16384, robots, words.of_robots),
}
