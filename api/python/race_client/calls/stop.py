"""Routes of api/openapi.yaml: stop. Made by generate/main.py. The request filter of the server may also refuse each."""
from ..call import Call
from ..messages import Control


def stop_cell() -> Call[Control]:
    """Stops the cell, for everybody who asks: every safe operation of all services is called, all runs are ended, and nothing moves
    until the reset. This is not a safety function. A body is not needed. A thread of its own serves the same on a port of its own
    (control.json, `stop_ports`), which reads a header of 1 KiB and nothing else, and answers `{"stopped": true}`.
    """
    return Call("POST", "/api/v1/stop")


def reset_stop() -> Call[Control]:
    """Motions may begin again; none does by that. Runs that the stop has ended are over. Of a cell that is not stopped nothing
    happens.
    """
    return Call("POST", "/api/v1/stop/reset")
