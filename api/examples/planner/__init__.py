"""A planner that sorts parts with the skills of a RACE server (README.md)."""
