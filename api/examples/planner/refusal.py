"""Why the planner does not, or no longer, sort."""


class Refused(Exception):
    """The text says why, for people: `there is no Cube on the table`."""
