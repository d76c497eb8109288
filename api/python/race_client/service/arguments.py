"""The arguments of a call, held against the parameters of its operation. Pure."""
import inspect
from collections.abc import Callable, Mapping
from typing import Any

from ..messages import Json

KINDS: dict[str, tuple[type, ...]] = {"number": (int, float), "int": (int,), "string": (str,), "bool": (bool,)}


def check_arguments(method: Callable[..., Any], parameters: list[Mapping[str, Json]], args: list[Json], kwargs: dict[str, Json]) -> Json:
    """The error that answers a call with these arguments, {"code", "message", "argument"}; None: they fit."""
    try:
        given = inspect.signature(method).bind(*args, **kwargs).arguments
    except TypeError as error:
        return {"code": "invalid", "message": str(error)}
    for parameter in parameters:
        name = parameter["name"]
        if name in given and (wrong := check_value(given[name], parameter)):
            return {**wrong, "argument": name}
    return None


def check_value(value: Json, parameter: Mapping[str, Json]) -> dict[str, Json]:
    """What is wrong with one argument; empty: nothing."""
    kinds = KINDS.get(parameter["type"]) if isinstance(parameter.get("type"), str) else None
    if kinds is not None and (not isinstance(value, kinds) or (isinstance(value, bool) and bool not in kinds)):
        return {"code": "invalid", "message": f"`{parameter['name']}` must be of type {parameter['type']}"}
    low, high = parameter.get("min"), parameter.get("max")
    is_number = isinstance(value, (int, float)) and not isinstance(value, bool)
    if is_number and ((low is not None and value < low) or (high is not None and value > high)):
        limits = " and ".join(f"at {word} {limit}" for word, limit in (("least", low), ("most", high)) if limit is not None)
        unit = f" {parameter['unit']}" if parameter.get("unit") else ""
        return {"code": "out_of_range", "message": f"`{parameter['name']}` must be {limits}{unit}"}
    return {}
