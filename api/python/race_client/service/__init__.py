"""Services of one's own: a class whose methods are operations that tasks call as `svc.KEY.OPERATION(...)`.

    from race_client.service import Service, operation

    class Lamp(Service):
        key = "lamp"

        @operation
        def switch(self, on: bool):
            print("on" if on else "off")

    Lamp().run()

`run` connects to the server, and again when the connection is lost; `await serve(Lamp())` does the same within asyncio. The server holds
what the service announces against its RSM, which is made of the class, or given: what does not fit is shown at its line.
"""
from .command import run, serve
from .declaration import DeclarationError, operation
from .service import Service, ServiceFailure, Stopped

__all__ = ["DeclarationError", "Service", "ServiceFailure", "Stopped", "operation", "run", "serve"]
