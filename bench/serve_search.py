#!/usr/bin/env python3
"""What a search by a member costs `rectilin serve` in a large collection: signatures of a database, perturbed until there
are enough, and requests one after the other.

    bench/serve_search.py RECTILIN SHAPES.db [MEMBERS [REQUESTS]] [--approximate]
"""
import json
import os
import re
import shutil
import signal
import sqlite3
import statistics
import subprocess
import sys
import tempfile
import time
import urllib.request

import numpy

NOISE = 6  # each byte moves by up to so much, as in bench_nearest


def grow(source, target, count):
    """A copy of a database with members added until there are `count`."""
    shutil.copy(source, target)
    database = sqlite3.connect(target)
    database.execute("PRAGMA synchronous = OFF")
    rows = database.execute("SELECT * FROM members WHERE status = 2").fetchall()
    parts = {}
    for member, part, data in database.execute("SELECT member, part, bytes FROM signatures"):
        parts.setdefault(member, []).append((part, numpy.frombuffer(data, numpy.uint8).astype(numpy.int16)))
    random = numpy.random.default_rng(1)
    first = max(row[0] for row in rows) + 1
    for k in range(count - len(rows)):
        row = rows[k % len(rows)]
        database.execute(f"INSERT INTO members VALUES({', '.join('?' * len(row))})",
                         (first + k, f"copy {k} of {row[1]}", *row[2:]))
        for part, values in parts[row[0]]:
            moved = numpy.clip(values + random.integers(-NOISE, NOISE + 1, values.size), 0, 255).astype(numpy.uint8)
            database.execute("INSERT INTO signatures VALUES(?, ?, ?)", (first + k, part, moved.tobytes()))
    database.commit()
    return [row[0] for row in database.execute("SELECT id FROM members WHERE status = 2")]


def cpu_seconds(process):
    with open(f"/proc/{process}/stat") as file:
        fields = file.read().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def main():
    words = [word for word in sys.argv[1:] if word != "--approximate"]
    approximate = ["--approximate"] if len(words) < len(sys.argv) - 1 else []
    rectilin, source = words[:2]
    count, requests = [int(x) for x in words[2:]] + [100_000, 50][len(words) - 2:]
    with tempfile.TemporaryDirectory() as folder:
        database = os.path.join(folder, "grown.db")
        ids = grow(source, database, count)
        begin = time.monotonic()
        server = subprocess.Popen([rectilin, "serve", database, "--port", "0", *approximate], stdout=subprocess.PIPE, text=True)
        try:
            url = re.search(r"http://\S+", server.stdout.readline()).group()
            print(f"{len(ids)} members; ready after {time.monotonic() - begin:.1f} s")
            walls, before = [], cpu_seconds(server.pid)
            for k in range(requests):
                begin = time.monotonic()
                with urllib.request.urlopen(f"{url}api/search?id={ids[k * 7919 % len(ids)]}&count=20") as answer:
                    assert len(json.load(answer)["results"]) == 20
                walls.append(1000 * (time.monotonic() - begin))
            cpu = 1000 * (cpu_seconds(server.pid) - before) / requests
        finally:
            server.send_signal(signal.SIGINT)
            server.wait()
    print(f"a search by a member: {statistics.median(walls):.1f} ms (median of {requests}; {min(walls):.1f} to "
          f"{max(walls):.1f}), {cpu:.1f} ms of processor time")


main()
