"""What a service may say: values that the server reads as they are."""
import json
from typing import Any

from ..messages import Json


def check_value(value: Any) -> None:
    """ValueError, TypeError: no JSON, a number that is not finite, an integer of more than 64 bits, or text that is no UTF-8."""
    json.dumps(value, allow_nan=False, ensure_ascii=False).encode()
    check_integers(value)


def check_integers(value: Any) -> None:
    if isinstance(value, int) and not -(2**63) <= value < 2**63:
        raise ValueError(f"{value} has more than 64 bits")
    for each in value.values() if isinstance(value, dict) else value if isinstance(value, list | tuple) else ():
        check_integers(each)


def checked_error(error: dict[str, Json]) -> Json:
    """The error of a method, or what is wrong with that."""
    try:
        if not isinstance(error.get("code"), str):
            raise TypeError("its `code` is no text")
        check_value(error)
    except (TypeError, ValueError) as wrong:
        return {"code": "failed", "message": f"the error of the operation is none: {wrong}"[:500]}
    return error
