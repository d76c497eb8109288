"""The asyncio client: `AsyncClient` of client.py, and what it is made of."""
