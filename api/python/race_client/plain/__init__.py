# Made from ../aio/__init__.py by generate/main.py.
"""The plain client: `Client` of client.py, and what it is made of."""
