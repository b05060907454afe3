"""What Python adds: to a call on a small mesh, to a call on 100,000 faces, and to an evaluation in batches of 50.

    PYTHONPATH=build/bench/python python3 bench/python_calls.py build/bench/bench/bench_calls

The argument is the program of the same calls in C++ (bench/calls.cpp). Times are of the
processor, of all threads, which other programs disturb less; the two are run in turn, and the least of each counts.
"""

import subprocess
import sys
import time

import numpy as np

import rectilin


def least(work, count, rounds=5):
    """Seconds a call."""
    best = float("inf")
    for _ in range(rounds):
        begin = time.process_time()
        for _ in range(count):
            work()
        best = min(best, (time.process_time() - begin) / count)
    return best


def in_cpp(what, count):
    return float(subprocess.run([sys.argv[1], what, str(count)], check=True, capture_output=True, text=True).stdout)


def in_turn(python, what, count, rounds=5):
    pairs = [(least(python, count, 1), in_cpp(what, count)) for _ in range(rounds)]
    return min(p for p, _ in pairs), min(c for _, c in pairs)


pyramid = rectilin.shape("pyramid")
V, F = pyramid.vertices.copy(), pyramid.faces.astype(np.int64)
here, there = in_turn(lambda: rectilin.measure(V, F), "small", 500)
print(f"measure, 6 faces: {here * 1e6:.1f} us, C++ {there * 1e6:.1f} us, Python adds {(here - there) * 1e6:.1f} us")

blob = rectilin.shape("blob?faces=100000")
for name, faces in [("uint32", blob.faces.copy()), ("int64", blob.faces.astype(np.int64))]:
    vertices = blob.vertices.copy()
    here, there = in_turn(lambda: rectilin.measure(vertices, faces), "large", 3)
    print(f"measure, 100,000 faces ({name}): {here * 1e3:.2f} ms, C++ {there * 1e3:.2f} ms: {100 * (here / there - 1):+.1f} %")

problem = rectilin.Problem("shape:pyramid")
turns = np.random.default_rng(1).normal(size=(50, 3))
batch = rectilin.domain("zone").rotation(turns)  # no two share a row, which would be summed once
spent = []


def search(asked, budget, rng):
    begin = time.process_time()
    for _ in range(budget // 50):
        asked.values(batch)
    spent.append((time.process_time() - begin) / budget)


for _ in range(5):
    rectilin.optimize(problem, search, budget=100000)
objective = in_cpp("values", 2000) / 50
print(f"evaluation in batches of 50: {min(spent) * 1e6:.2f} us, objective {objective * 1e6:.2f} us, "
      f"Python adds {(min(spent) - objective) * 1e6:.2f} us")
