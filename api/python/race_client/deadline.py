"""The time until which all parts of something must be done."""
import time


class Deadline:
    """`seconds` from now."""

    def __init__(self, seconds: float) -> None:
        self._end = time.monotonic() + seconds

    def left(self) -> float:
        """Seconds that are left, more than 0. TimeoutError: none are."""
        left = self._end - time.monotonic()
        if left <= 0:
            raise TimeoutError
        return left
