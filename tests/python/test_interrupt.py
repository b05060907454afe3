"""Ctrl-C, and arrays that change while C++ looks at them."""

import os
import signal
import subprocess
import sys
import textwrap
import threading
import time

import numpy as np
import pytest

import rectilin


def interrupted(body, tmp_path, after=1.5):
    """Runs `body` in another Python, presses Ctrl-C once it says it has begun; returns what it prints."""
    script = "import rectilin, sys, numpy as np\nprint('begun', flush=True)\ntry:\n" + textwrap.indent(textwrap.dedent(body), "    ")
    script += "\nexcept KeyboardInterrupt:\n    print('interrupted')\n"
    process = subprocess.Popen([sys.executable, "-c", script], cwd=tmp_path, stdout=subprocess.PIPE, text=True)
    try:
        assert process.stdout.readline() == "begun\n"
        time.sleep(after)
        process.send_signal(signal.SIGINT)
        said, _ = process.communicate(timeout=60)
        return said
    finally:
        process.kill()


@pytest.mark.parametrize(
    "body",
    [
        "rectilin.measure('shape:sphere?subdivisions=3&noise=0.0001', optimizer='random?evaluations=2000000000')",
        "rectilin.optimize('shape:box', 'random?evaluations=2000000000', budget=None)",
        """
        def forever(problem, budget, rng):
            while True: problem.values(rng.normal(size=(50, 4)))
        rectilin.optimize('shape:box', forever, budget=None)
        """,
        """
        def silent(problem, budget, rng):
            while True: pass
        rectilin.compare('shape:box', silent, out='a')
        """,
        "rectilin.compare('shape:blob?faces=20000', 'random', runs=10000, budget=100000, out='b')",
    ],
    ids=["measure", "optimize", "own", "silent in compare", "compare"],
)
def test_ctrl_c(body, tmp_path):
    assert interrupted(body, tmp_path) == "interrupted\n"


def test_progress_is_told_and_may_raise():
    told = []

    def progress(evaluations, seconds, lower, upper):
        told.append(evaluations)
        if len(told) == 3:
            raise ZeroDivisionError("enough")

    with pytest.raises(ZeroDivisionError, match="enough"):
        rectilin.optimize("shape:box", "random?evaluations=2000000000", budget=None, progress=progress)
    assert told[0] < told[1] < told[2]


def test_arrays_changed_meanwhile():
    mesh = rectilin.shape("blob?faces=20000")
    vertices, faces = mesh.vertices.copy(), mesh.faces.copy()
    stop = threading.Event()
    rng = np.random.default_rng(1)

    def scribble():
        while not stop.is_set():
            faces[:] = rng.integers(0, 2**32, faces.shape, dtype=np.uint32)
            vertices[rng.integers(len(vertices))] = rng.choice([np.nan, np.inf, 1e300, -1e-300])
            faces[:] = mesh.faces
            vertices[:] = mesh.vertices

    thread = threading.Thread(target=scribble)
    thread.start()
    try:
        for _ in range(30):
            try:
                rectilin.measure(vertices, faces, budget=50, optimizer="random")
            except ValueError:
                pass
    finally:
        stop.set()
        thread.join()
    assert rectilin.measure(vertices, faces, optimizer="random", budget=50).rectilinearity > 0
