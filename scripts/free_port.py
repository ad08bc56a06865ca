"""Ports for servers that scripts start."""

import random
import socket


def free_port():
    """Not one of those that the system gives to connections (32768 to 60999), which may take it before the server does. The next is
    free as well: `endless serve` streams there."""
    while True:
        port = random.SystemRandom().randrange(10_000, 30_000)
        try:
            for taken in (port, port + 1):
                with socket.socket() as s:
                    s.bind(("127.0.0.1", taken))
        except OSError:
            continue
        return port
