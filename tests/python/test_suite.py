"""Suites, problems for other programs, and their results on a comparison's page."""

import json
import pathlib
import subprocess

import numpy as np
import pytest

import rectilin
from conftest import random_rotations


def test_a_suite_never_changes():
    # Faces, directions, the sum of squares of the vectors' lengths, and P/S at the identity.
    expected = {
        "box": (12, 3, 0.40495868, 1.58923463),
        "lshape": (20, 3, 0.33884298, 1.38459092),
        "pyramid": (6, 5, 0.21485588, 1.54532323),
        "prism": (20, 4, 0.25362887, 1.52669653),
        "cut-cube": (16, 4, 0.28572137, 1.57968764),
        "stairs": (36, 3, 0.34693878, 1.61534649),
        "stepped-pyramid": (316, 3, 0.36912552, 1.42990548),
        "filleted-cube": (3468, 1635, 0.06638225, 1.54279117),
        "noisy-cube": (3468, 3468, 0.01175261, 1.54914711),
        "cylinder": (252, 38, 0.06853144, 1.57421953),
        "torus": (4096, 512, 0.00195313, 1.49344845),
        "ellipsoid": (10000, 7871, 0.00014081, 1.52355134),
        "blob": (5000, 5000, 0.00022418, 1.49458725),
        "blob-coarse": (200, 200, 0.00543623, 1.46414701),
        "soup": (1000, 1000, 0.00136486, 1.49798404),
    }
    problems = rectilin.suite("landscapes-1")
    assert list(problems) == list(expected)
    for name, problem in problems.items():
        faces, directions, squares, value = expected[name]
        assert (problem.faces, problem.directions) == (faces, directions)
        assert (problem.vectors**2).sum() == pytest.approx(squares, abs=2e-8)
        assert problem.values(np.eye(3)) == pytest.approx(value, abs=2e-8)


def test_command_and_module_agree(command, tmp_path):
    listed = subprocess.run([command, "suite", "landscapes-1"], check=True, capture_output=True, text=True).stdout.split("\n")
    here = [p["source"] for p in rectilin.suites()[0]["problems"]]
    assert listed[:-1] == here
    subprocess.run([command, "suite", "shape:pyramid", "shape:box", "-O", tmp_path / "problems"], check=True, capture_output=True)
    manifest = json.loads((tmp_path / "problems/suite.json").read_text())
    assert [p["name"] for p in manifest["problems"]] == ["pyramid", "box"]
    problem = json.loads((tmp_path / "problems/pyramid.json").read_text())
    rectilin.export("shape:pyramid", "pyramid.json")
    again = json.loads(pathlib.Path("pyramid.json").read_text())
    for key in ["vectors", "value", "value_lower", "rotation", "upper", "directions"]:
        assert problem[key] == again[key]


@pytest.mark.parametrize("ending", ["json", "npz"])
def test_exported_problem_is_the_problem(ending):
    problem = rectilin.Problem("shape:blob?faces=300&rotate=random")
    rectilin.export(problem, f"p.{ending}")
    data = np.load("p.npz") if ending == "npz" else json.loads(pathlib.Path("p.json").read_text())
    vectors = np.asarray(data["vectors"])
    rotations = random_rotations(50)
    values = np.abs(np.einsum("nij,vj->nvi", rotations, vectors)).sum(axis=(1, 2))
    assert problem.values(rotations) == pytest.approx(values, abs=1e-12)
    assert (values >= data["value_lower"]).all()
    assert np.abs(vectors @ np.asarray(data["rotation"]).T).sum() == pytest.approx(float(data["value"]), abs=1e-12)
    assert data["lower"] <= data["rectilinearity"] + 1e-11 and data["upper"] - data["lower"] < 1e-8


def test_bad_exports():
    with pytest.raises(rectilin.ParameterError, match="no suite 'landscape-1'; did you mean 'landscapes-1'"):
        rectilin.suite("landscape-1")
    with pytest.raises(rectilin.ParameterError, match=".json or .npz"):
        rectilin.export("shape:box", "box.xml")


@pytest.fixture
def comparison():
    return rectilin.compare(["shape:pyramid", "shape:box"], {"grid": "grid"}, runs=2, budget=100, out="out")


def foreign(problem="pyramid", **changes):
    """A run as another program might write it: random rotations on the exported vectors, by numpy alone."""
    vectors = rectilin.Problem(f"shape:{problem}").vectors
    rotations = random_rotations(60, seed=8)
    values = np.abs(np.einsum("nij,vj->nvi", rotations, vectors)).sum(axis=(1, 2))
    best = np.minimum.accumulate(values)
    steps = np.flatnonzero(np.diff(best, prepend=np.inf) < 0)
    line = {"problem": problem, "optimizer": "numpy", "run": 0, "evaluations": (steps + 1).tolist(),
            "value": best[steps].tolist(), "rotation": rotations[values.argmin()].tolist(), "total_evaluations": 60}
    line.update(changes)
    return line


def write(*lines):
    pathlib.Path("runs.jsonl").write_text("".join(json.dumps(line) + "\n" for line in lines))
    return "runs.jsonl"


def test_foreign_runs_are_on_the_page(comparison, command):
    assert rectilin.read_traces("out", write(foreign(), foreign(run=1), foreign("box"))) == 3
    assert "numpy" in pathlib.Path(comparison.page).read_text()
    assert "numpy" in json.dumps(comparison.summary)
    done = subprocess.run([command, "suite", "--traces", write(foreign(run=2, optimizer="other")), "--into", "out"],
                          check=True, capture_output=True, text=True)
    assert "1 runs read" in done.stdout
    page = pathlib.Path(comparison.page).read_text()
    assert "numpy" in page and "other" in page
    # The comparison itself goes on as it was.
    again = rectilin.compare(["shape:pyramid", "shape:box"], {"grid": "grid"}, runs=2, budget=100, out="out")
    assert len(again.runs) == 4


@pytest.mark.parametrize(
    "changes, text",
    [
        ({"problem": "cone"}, "no problem 'cone'"),
        ({"optimizer": "grid"}, "has an optimizer 'grid' of its own"),
        ({"optimizer": 5}, "'optimizer' is no text"),
        ({"run": -1}, "'run' is not a whole number"),
        ({"evaluations": []}, "of the same length"),
        ({"evaluations": "x"}, "not a list of numbers"),
        ({"value": [1.2, 1.3], "evaluations": [1, 2]}, "'value' does not fall at element 1"),
        ({"value": [1.3, 1.2], "evaluations": [2, 2]}, "'evaluations' does not rise at element 1"),
        ({"value": [1.01], "evaluations": [1]}, "does not have the last value"),
        ({"rotation": [[1, 0, 0], [0, 1, 0], [0, 0, 2]]}, "orthonormal"),
        ({"rotation": None}, "orthonormal"),
        ({"total_evaluations": 1}, "less than the last"),
        ({"evaluations": [0.5], "value": [1.2]}, "whole numbers of 1 or more"),
    ],
)
def test_foreign_runs_are_not_believed(comparison, changes, text):
    with pytest.raises(rectilin.ParameterError, match=text) as error:
        rectilin.read_traces("out", write(foreign(), {**foreign(run=1), **changes}))
    assert str(error.value).startswith("runs.jsonl:line 2: ")
    assert not pathlib.Path("out/foreign.jsonl").exists()


def test_foreign_text_that_is_no_runs(comparison):
    pathlib.Path("runs.jsonl").write_text("{")
    with pytest.raises(rectilin.ParameterError, match="line 1: not a JSON object"):
        rectilin.read_traces("out", "runs.jsonl")
    pathlib.Path("runs.jsonl").write_text("\n")
    with pytest.raises(rectilin.ParameterError, match="contains no runs"):
        rectilin.read_traces("out", "runs.jsonl")
    with pytest.raises(RuntimeError, match="no comparison"):
        rectilin.read_traces("nowhere", "runs.jsonl")


def test_problems_in_memory(tetrahedron):
    problems = {"corner": rectilin.Problem(*tetrahedron)}
    rectilin.compare(problems, {"grid": "grid"}, runs=1, budget=50, out="memory")
    vectors = problems["corner"].vectors
    line = foreign(problem="pyramid")
    line.update(problem="corner", evaluations=[1], value=[float(np.abs(vectors).sum())], rotation=np.eye(3).tolist())
    assert rectilin.read_traces("memory", write(line), problems) == 1
