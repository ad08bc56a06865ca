"""Ports for servers that scripts start."""

import random
import socket
import sys
import time


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


def wait_until_it_listens(process, port, limit_s=120):
    """Until a server that was started is ready; ends the script if it never is."""
    deadline = time.monotonic() + limit_s
    while time.monotonic() < deadline:
        if process.poll() is not None:
            sys.exit(f"the server ended with {process.returncode}")
        try:
            socket.create_connection(("127.0.0.1", port), 1).close()
            return
        except OSError:
            time.sleep(0.1)
    sys.exit("the server does not listen")
