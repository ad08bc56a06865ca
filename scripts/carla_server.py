"""`endless serve`, for the scripts that ask it something."""

import socket
import subprocess
import sys
import time

from free_port import free_port


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


class Server:
    """A server that ends with the script: on a port of its own, or on one that must be free."""

    def __init__(self, program, town, port=None, flags=(), log=None):
        if port is not None:
            with socket.socket() as other:
                if other.connect_ex(("127.0.0.1", port)) == 0:
                    sys.exit(f"port {port} is in use: choose another one")
        self.port = port or free_port()
        command = [program, "serve", "--map", town, "--port", str(self.port), *flags]
        self.process = subprocess.Popen(command, stdout=log, stderr=log and subprocess.STDOUT)
        wait_until_it_listens(self.process, self.port)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.terminate()
        self.process.wait()
