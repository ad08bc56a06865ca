"""`endless serve`, for the scripts that ask it something."""

import socket
import subprocess
import sys

from ports import free_port, wait_until_it_listens


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
