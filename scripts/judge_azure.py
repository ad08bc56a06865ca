#!/usr/bin/env python3
"""Judges `endless generate az://...` with Azurite, Microsoft's emulator of Azure Blob Storage, from npm.

    npm install --prefix FOLDER azurite
    python3 -m venv VENV && VENV/bin/pip install azure-storage-blob
    VENV/bin/python scripts/judge_azure.py path/to/endless FOLDER [KILLS]

The program must be built with `--features cloud`. A dataset is made in a folder and in a container, in one go and killed at random
instants, and all bytes are compared.
"""

import os
import pathlib
import random
import subprocess
import sys
import tempfile
import time

from azure.storage.blob import BlobServiceClient

from folder_bytes import folder_bytes
from ports import wait_until_it_listens

# Azurite's only account, with the key that its documentation gives.
ACCOUNT = "devstoreaccount1"
KEY = "Eby8vdM02xNOcqFlqUwJPLlmEtlCDXJ1OUzFT50uSRZ6IFsuFq2UVErCz4I6tq/K1SZFPTOtr/KBHBeksoGMGw=="
# Where object_store looks for an emulator.
PORT = 10000
RECIPE = ["--videos", "3", "--size", "64x36", "--fps", "5", "--duration", "2", "--seed", "5", "--min-pixels", "5"]
RECIPE += ["--maps", "Town01,Town03", "--vehicles", "10", "--pedestrians", "5"]


def start_server(folder: str, work: pathlib.Path) -> subprocess.Popen:
    program = pathlib.Path(folder) / "node_modules/.bin/azurite-blob"
    options = ["--blobPort", str(PORT), "--location", str(work / "azurite"), "--silent", "--skipApiVersionCheck"]
    server = subprocess.Popen([program, *options], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    wait_until_it_listens(server, PORT)
    return server


def judge(endless: str, service: BlobServiceClient, work: pathlib.Path, kills: int) -> None:
    environment = {**os.environ, "AZURE_STORAGE_USE_EMULATOR": "true"}
    said: list[str] = []

    def run(*arguments: str) -> tuple[int, str]:
        ended = subprocess.run([endless, "-vv", *arguments], capture_output=True, text=True, env=environment)
        said.append(ended.stdout + ended.stderr)
        return ended.returncode, ended.stderr

    def generate(out: str) -> list[str]:
        return ["generate", out, *RECIPE, "--work-dir", str(work / "cache"), "--reconnect-timeout", "3"]

    def objects(prefix: str) -> dict[str, bytes]:
        names = service.get_container_client("data").list_blob_names(name_starts_with=prefix + "/")
        read = service.get_blob_client
        return {os.path.relpath(name, prefix): read("data", name).download_blob().readall() for name in names}

    begin = time.monotonic()
    assert run("generate", str(work / "local"), *RECIPE)[0] == 0, said[-1][-2000:]
    seconds, wanted = time.monotonic() - begin, folder_bytes(work / "local")

    service.create_container("data")
    assert run(*generate("az://data/whole/a"))[0] == 0, said[-1][-2000:]
    assert objects("whole/a") == wanted
    assert "all is well" in "".join(run("check", "az://data/whole/a")[1:]) + said[-1]
    print(f"whole: {len(wanted)} objects as in a folder")

    dice, killed = random.Random(1), 0
    for _ in range(kills):
        out = [endless, *generate("az://data/killed")]
        process = subprocess.Popen(out, env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        try:
            process.wait(dice.uniform(0.1, seconds))
        except subprocess.TimeoutExpired:
            process.kill()
            killed += process.wait() != 0
    assert run(*generate("az://data/killed"))[0] == 0, said[-1][-2000:]
    assert objects("killed") == wanted
    print(f"killed {killed} times: the same")

    code, error = run(*generate("az://nobody/a"))
    assert code != 0 and "no such bucket" in error, error
    code, error = run(*generate(f"az://data/a?sig={KEY}"))
    assert code != 0 and "must not hold" in error, error
    assert not any(KEY in text for text in said), "a key was told"
    print("what cannot work is told, and no key")


def main() -> None:
    kills = int(sys.argv[3]) if len(sys.argv) > 3 else 5
    with tempfile.TemporaryDirectory() as folder:
        work = pathlib.Path(folder)
        server = start_server(sys.argv[2], work)
        try:
            endpoint = f"http://127.0.0.1:{PORT}/{ACCOUNT}"
            account = f"DefaultEndpointsProtocol=http;AccountName={ACCOUNT};AccountKey={KEY};BlobEndpoint={endpoint};"
            judge(os.path.abspath(sys.argv[1]), BlobServiceClient.from_connection_string(account), work, kills)
        finally:
            server.kill()
            server.wait()


if __name__ == "__main__":
    main()
