"""Routes of api/openapi.yaml: control. Made by generate/main.py. The request filter of the server may also refuse each."""
from ..call import Call
from ..messages import Control, ControlAnswer, ControlMode


def get_control() -> Call[Control]:
    """Whether the cell is stopped, what runs have reserved, and where a stop is served. Who is not known learns no names."""
    return Call("GET", "/api/v1/control")


def answer_control_request(body: ControlAnswer) -> Call[Control]:
    """A person at the cell lets somebody take the controls from who has them (control.json, `request`), or not. What moved by them
    stops. At a server with accounts, an account of the group `local` alone may answer; at one without, everybody on its machine.

    400: The body is no JSON or out of its limits (`json`, `too_deep`, `out_of_range`).

    404: Nobody asks with that, or no more.

    422: The body does not fit its schema.
    """
    return Call("POST", "/api/v1/control/answer", body=body)


def set_cell_mode(body: ControlMode, *, race_control: str | None = None) -> Call[Control]:
    """Sets the mode of the cell. What moves stops, and runs that moved something, or are watched, are paused. It stays over a
    restart.

    race_control: The secret of the message `taken` (control_message.json): who sends the request has the controls of the cell.
    409 (`leased`): they have them no more.

    400: The body is no JSON or out of its limits (`json`, `too_deep`, `out_of_range`).

    409: `leased`: who asks has not the controls of the cell.

    422: The body does not fit its schema.
    """
    return Call("PUT", "/api/v1/control/mode", headers={"Race-Control": race_control}, body=body)
