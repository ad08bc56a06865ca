#!/usr/bin/env python3
"""Judges `endless generate s3://...` with a real S3 server: moto, from PyPI.

    python3 -m venv VENV && VENV/bin/pip install "moto[server]" boto3 trustme
    VENV/bin/python scripts/judge_storage.py path/to/endless [--kills 10] [--throughput]

The program must be built with `--features cloud`. A dataset is made in a folder and in a bucket, and all bytes are compared:
in one go, killed at random instants, by eight shards at a time, over connections that break, with TLS. Then what cannot work must say so in one line,
lose nothing, and nowhere tell a secret. With --throughput it also measures uploads, and judges nothing by them.
"""
import argparse
import http.client
import http.server
import json
import os
import random
import re
import socket
import subprocess
import sys
import tempfile
import threading
import time

import boto3
import botocore.config
import trustme

from folder_bytes import folder_bytes
from ports import free_port, wait_until_it_listens

SECRET = "wJalrXUtnFEMIK7MDENGbPxRfiCYEXAMPLESECRET"
KEY = "AKIAHIDDENEXAMPLE"
RECIPE = ["--videos", "8", "--size", "64x36", "--fps", "5", "--duration", "1", "--seed", "5", "--min-pixels", "5",
          "--maps", "Town01,Town03", "--vehicles", "10", "--pedestrians", "5"]
outputs = []
begun = time.monotonic()


def recipe(*flags):
    """The recipe with other flags."""
    changed = dict(zip(RECIPE[::2], RECIPE[1::2]))
    changed.update(zip(flags[::2], flags[1::2]))
    return [word for pair in changed.items() for word in pair]


class Judge:
    def __init__(self, endless, work):
        self.endless, self.work = endless, work
        self.port = free_port()
        self.server = None
        self.start_server()
        self.local = os.path.join(work, "local")
        begin = time.monotonic()
        self.run([self.local, *RECIPE])
        self.local_seconds = time.monotonic() - begin
        self.wanted = folder_bytes(self.local)

    def start_server(self, tls=None, **settings):
        """An empty server; with TLS where there are an authority's, its own certificate and its key."""
        self.stop_server()
        program = os.path.join(os.path.dirname(sys.executable), "moto_server")
        secured = ["-s", "-c", tls[1], "-k", tls[2]] if tls else []
        self.server = subprocess.Popen([program, "-p", str(self.port), *secured], stdout=subprocess.DEVNULL,
                                       stderr=subprocess.DEVNULL, env={**os.environ, **settings})
        wait_until_it_listens(self.server, self.port)
        self.s3 = boto3.client("s3", endpoint_url=f"{'https' if tls else 'http'}://127.0.0.1:{self.port}",
                               region_name="us-east-1", verify=tls[0] if tls else None,
                               aws_access_key_id=KEY, aws_secret_access_key=SECRET,
                               config=botocore.config.Config(retries={"max_attempts": 1}))

    def stop_server(self):
        if self.server:
            self.server.kill()
            self.server.wait()
            self.server = None

    def environment(self, port=None, **more):
        plain = {k: v for k, v in os.environ.items() if not k.startswith("AWS_")}
        return {**plain, "AWS_ENDPOINT_URL": f"http://127.0.0.1:{port or self.port}", "AWS_ALLOW_HTTP": "true",
                "AWS_ACCESS_KEY_ID": KEY, "AWS_SECRET_ACCESS_KEY": SECRET, "AWS_REGION": "us-east-1", **more}

    def command(self, arguments, command="generate"):
        work = [] if command != "generate" else ["--work-dir", os.path.join(self.work, "cache"), "--reconnect-timeout", "3"]
        return [self.endless, "-vv", command, *arguments, *work]

    def run(self, arguments, command="generate", **environment):
        """What a run says that must work."""
        code, said = self.try_run(arguments, command, **environment)
        assert code == 0, said[-2000:]
        return said

    def try_run(self, arguments, command="generate", **environment):
        ended = subprocess.run(self.command(arguments, command), capture_output=True, text=True,
                               env=self.environment(**environment))
        outputs.append(ended.stdout + ended.stderr)
        return ended.returncode, ended.stderr

    def refused(self, arguments, wanted, command="generate", **environment):
        """The one line of a run that must be refused."""
        code, said = self.try_run(arguments, command, **environment)
        errors = [line for line in said.splitlines() if line.startswith("error: ")]
        assert code != 0 and len(errors) == 1, (code, said[-2000:])
        assert re.search(wanted, errors[0]), f"wanted {wanted}: {errors[0]}"
        print("   ", errors[0], flush=True)

    def objects(self, bucket, prefix):
        """All objects with their bytes. Nothing of them may be secret."""
        found = {}
        for page in self.s3.get_paginator("list_objects_v2").paginate(Bucket=bucket, Prefix=prefix):
            for entry in page.get("Contents", []):
                body = self.s3.get_object(Bucket=bucket, Key=entry["Key"])["Body"].read()
                assert SECRET.encode() not in body and KEY.encode() not in body
                found[os.path.relpath(entry["Key"], prefix)] = body
        return found

    def assert_same(self, bucket, prefix):
        found = self.objects(bucket, prefix)
        assert found.keys() == self.wanted.keys(), sorted(found.keys() ^ self.wanted.keys())[:5]
        differ = [name for name in found if found[name] != self.wanted[name]]
        assert not differ, differ[:5]

    def bucket(self, name):
        self.s3.create_bucket(Bucket=name)
        return name


class Proxy:
    """Stands between both ends; `spoil` says what becomes of a request: nothing, an answer, or a cut connection.
    `headers` are put in the place of the request's own."""

    def __init__(self, port, spoil, headers=None):
        proxy = self

        class Handler(http.server.BaseHTTPRequestHandler):
            protocol_version = "HTTP/1.1"

            def handle_any(self):
                length = int(self.headers.get("content-length", 0))
                with proxy.lock:
                    proxy.requests += 1
                    fate = spoil(proxy.requests, self.command, self.path)
                if fate == "cut":
                    # In the middle of the body.
                    self.rfile.read(length // 2)
                    self.connection.shutdown(socket.SHUT_RDWR)
                    self.close_connection = True
                    return
                body = self.rfile.read(length)
                if fate:
                    status, code = fate
                    self.answer(status, {}, f"<Error><Code>{code}</Code><Key>{SECRET}</Key></Error>".encode())
                    return
                upstream = http.client.HTTPConnection("127.0.0.1", port, timeout=60)
                own = {name: value for name, value in self.headers.items() if name.lower() not in (headers or {})}
                upstream.request(self.command, self.path, body, {**own, **(headers or {})})
                answer = upstream.getresponse()
                self.answer(answer.status, dict(answer.getheaders()), answer.read())
                upstream.close()

            def answer(self, status, headers, body):
                self.send_response_only(status)
                for name, value in headers.items():
                    if name.lower() not in ("content-length", "transfer-encoding", "connection"):
                        self.send_header(name, value)
                length = headers.get("Content-Length", len(body)) if self.command == "HEAD" else len(body)
                self.send_header("Content-Length", str(length))
                self.end_headers()
                if self.command != "HEAD":
                    self.wfile.write(body)

            do_GET = do_PUT = do_POST = do_DELETE = do_HEAD = handle_any

            def log_message(self, *_):
                pass

        self.requests, self.lock = 0, threading.Lock()
        self.server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), Handler)
        self.server.daemon_threads = True
        # Whoever is refused does not read to the end.
        self.server.handle_error = lambda *_: None
        self.port = self.server.server_address[1]
        threading.Thread(target=self.server.serve_forever, daemon=True).start()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.server.shutdown()
        self.server.server_close()


def certificates(folder):
    """Files: an authority's certificate, a server's that it signed, the server's key."""
    authority = trustme.CA()
    server = authority.issue_cert("127.0.0.1")
    paths = [os.path.join(folder, name) for name in ("authority.pem", "server.pem", "server.key")]
    authority.cert_pem.write_to_path(paths[0])
    server.cert_chain_pems[0].write_to_path(paths[1])
    server.private_key_pem.write_to_path(paths[2])
    return paths


def is_upload(command, path):
    return command == "PUT" and "/videos/" in path


def step(text):
    print(f"== {text} ({time.monotonic() - begun:.0f} s)", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("endless")
    parser.add_argument("--kills", type=int, default=10)
    parser.add_argument("--throughput", action="store_true")
    asked = parser.parse_args()
    with tempfile.TemporaryDirectory() as work:
        judge = Judge(os.path.abspath(asked.endless), work)
        try:
            judge_all(judge, asked.kills)
            if asked.throughput:
                measure_throughput(judge)
        finally:
            judge.stop_server()
    for said in outputs:
        for secret in (SECRET, KEY, "hunter2"):
            assert secret not in said, said[max(0, said.index(secret) - 200):][:400]
    print(f"no secret in {len(outputs)} outputs at -vv, nor in any object")


def judge_all(judge, kills):
    step("whole")
    judge.bucket("whole")
    begin = time.monotonic()
    judge.run(["s3://whole/a/b", *RECIPE])
    seconds = time.monotonic() - begin
    judge.assert_same("whole", "a/b")
    print(f"{len(judge.wanted)} files the same; {seconds:.1f} s to the bucket, {judge.local_seconds:.1f} s to a folder")
    left = folder_bytes(os.path.join(judge.work, "cache"))
    assert not left, f"left behind: {list(left)[:5]}"
    assert "nothing to do" in judge.run(["s3://whole/a/b", *RECIPE])
    said = judge.run(["s3://whole/a/b"], "check")
    assert "all is well" in said
    judge.refused(["s3://whole/a/b", *recipe("--seed", "6")], "another recipe .*s3://whole/a/b$")
    judge.refused(["s3://whole/empty"], "no such object.*s3://whole/empty/dataset.json$", "check")

    step("a plan alone")
    judge.bucket("planned")
    judge.run(["s3://planned/a", *RECIPE, "--plan-only"])
    names = set(judge.objects("planned", "a"))
    assert names == {name for name in judge.wanted if not name.startswith("videos")}, names
    judge.run(["s3://planned/a", *RECIPE])
    judge.assert_same("planned", "a")

    step("files lost in the bucket")
    lost = [name for name in judge.wanted if name.endswith(".png")][3]
    judge.s3.delete_object(Bucket="whole", Key=f"a/b/{lost}")
    code, _ = judge.try_run(["s3://whole/a/b"], "check")
    assert code == 1
    judge.run(["s3://whole/a/b", *RECIPE])
    judge.assert_same("whole", "a/b")

    step(f"killed {kills} times")
    judge.bucket("killed")
    dice, killed = random.Random(1), 0
    for _ in range(kills):
        process = subprocess.Popen(judge.command(["s3://killed/a", *RECIPE]), env=judge.environment(),
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        try:
            process.wait(dice.uniform(0.1, judge.local_seconds / 3))
        except subprocess.TimeoutExpired:
            process.kill()
            killed += process.wait() != 0
    judge.run(["s3://killed/a", *RECIPE])
    judge.assert_same("killed", "a")
    print(f"{killed} of {kills} runs were killed before their end; the objects are the same")

    step("eight shards at a time")
    judge.bucket("shards")
    shards = [subprocess.Popen(judge.command(["s3://shards/a", *RECIPE, "--shard", f"{i}/8", "--threads", "1"]),
                               env=judge.environment(), stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
              for i in range(1, 9)]
    for shard in shards:
        said, _ = shard.communicate()
        outputs.append(said)
        assert shard.returncode == 0, said[-2000:]
    judge.assert_same("shards", "a")

    step("connections that are cut, and a server that asks to slow down")
    judge.bucket("cut")
    fates = random.Random(2)
    with Proxy(judge.port, lambda *_: fates.choice([None] * 18 + ["cut", (503, "SlowDown")])) as proxy:
        judge.run(["s3://cut/a", *RECIPE], port=proxy.port)
    judge.assert_same("cut", "a")

    step("what cannot work")
    judge.refused(["s3://nobody/a", *RECIPE], "no such bucket.*s3://nobody$|no such bucket.*s3://nobody/a$")
    judge.bucket("full")
    full = lambda status, code: lambda n, *request: (status, code) if n > 60 and is_upload(*request) else None
    for status, code in ((507, "InsufficientStorage"), (403, "QuotaExceeded")):
        with Proxy(judge.port, full(status, code)) as proxy:
            judge.refused(["s3://full/a", *RECIPE], "full or a quota.*same command goes on", port=proxy.port)
    with Proxy(judge.port, lambda n, *request: (503, "SlowDown") if n > 60 and is_upload(*request) else None) as proxy:
        judge.refused(["s3://full/a", *RECIPE], "too busy.*same command goes on", port=proxy.port)
    with Proxy(judge.port, lambda n, *request: "cut" if n > 60 and is_upload(*request) else None) as proxy:
        judge.refused(["s3://full/a", *RECIPE], "cannot be reached.*same command goes on", port=proxy.port)
    with Proxy(judge.port, lambda *_: (403, "AccessDenied")) as proxy:
        judge.refused(["s3://full/a", *RECIPE], "do not allow that .AccessDenied", port=proxy.port)
    with Proxy(judge.port, lambda *_: (400, "AuthorizationHeaderMalformed")) as proxy:
        judge.refused(["s3://full/a", *RECIPE], "another region: set AWS_REGION", port=proxy.port)
    judge.refused(["s3://full/a", *RECIPE], "cannot be reached.*refused", port=free_port())
    judge.run(["s3://full/a", *RECIPE])
    judge.assert_same("full", "a")
    for out in (f"s3://{KEY}:hunter2@full/a", "s3://full/a?key=hunter2"):
        judge.refused([out, *RECIPE], "must not hold a user, a password or a key")
    judge.refused(["ftp://full/a", *RECIPE], "unknown kind of address")

    step("credentials that are not known, as moto checks them")
    judge.start_server(INITIAL_NO_AUTH_ACTION_COUNT="1")
    judge.s3.create_bucket(Bucket="guarded")
    judge.refused(["s3://guarded/a", *RECIPE], "credentials are not accepted .InvalidAccessKeyId")

    step("TLS, with a certificate of somebody whom the system does not know")
    tls = certificates(judge.work)
    judge.start_server(tls=tls)
    judge.bucket("secure")
    secure = {"AWS_ENDPOINT_URL": f"https://127.0.0.1:{judge.port}", "AWS_ALLOW_HTTP": "false"}
    judge.refused(["s3://secure/a", *RECIPE], "cannot be reached.*certificate", **secure)
    judge.run(["s3://secure/a", *RECIPE], **secure, SSL_CERT_FILE=tls[0])
    judge.assert_same("secure", "a")

    step("Google's client, whose requests moto understands but for their credentials")
    judge.start_server()
    judge.bucket("google")
    scope = f"{KEY}/20260101/us-east-1/s3/aws4_request"
    accepted = {"authorization": f"AWS4-HMAC-SHA256 Credential={scope}, SignedHeaders=host, Signature=0"}
    with Proxy(judge.port, lambda *_: None, headers=accepted) as proxy:
        account = os.path.join(judge.work, "account.json")
        with open(account, "w") as file:
            json.dump({"gcs_base_url": f"http://127.0.0.1:{proxy.port}", "disable_oauth": True, "client_email": "",
                       "private_key": SECRET, "private_key_id": KEY}, file)
        judge.run(["gs://google/a", *RECIPE], GOOGLE_SERVICE_ACCOUNT=account)
        judge.assert_same("google", "a")
        assert "all is well" in judge.run(["gs://google/a"], "check", GOOGLE_SERVICE_ACCOUNT=account)
        judge.refused(["gs://nobody/a", *RECIPE], "no such bucket", GOOGLE_SERVICE_ACCOUNT=account)


def measure_throughput(judge):
    step("throughput")
    judge.start_server()
    judge.bucket("speed")
    # 2 cameras, 3 layers, 170 frames.
    pictures = recipe("--videos", "1", "--duration", "34", "--size", "320x180")
    folder = os.path.join(judge.work, "speed")
    begin = time.monotonic()
    judge.run([folder, *pictures])
    local = time.monotonic() - begin
    begin = time.monotonic()
    judge.run(["s3://speed/a", *pictures])
    there = time.monotonic() - begin
    made = folder_bytes(folder)
    images = sum(name.endswith(".png") for name in made)
    megabytes = sum(map(len, made.values())) / 1e6
    print(json.dumps({"images": images, "MB": round(megabytes, 1), "seconds to a folder": round(local, 1),
                      "seconds to a bucket": round(there, 1),
                      "uploads a second": round(len(made) / max(there - local, 0.1))}))


if __name__ == "__main__":
    main()
