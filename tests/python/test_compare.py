"""compare(): Python callables among the library's optimizers."""

import json
import pathlib
import threading
import time

import numpy as np
import pytest

import rectilin


def dice(problem, budget, rng):
    while True:
        problem.values(rng.normal(size=(50, 4)))


def compare(optimizers, problems="shape:pyramid", **keywords):
    keywords = {"runs": 3, "budget": 200, "out": "out", **keywords}
    return rectilin.compare(problems, optimizers, **keywords)


def test_own_and_built_in_on_one_budget():
    result = compare({"grid": "grid", "mine": dice, "ga in the zone": "ga@zone"}, ["shape:pyramid", "shape:blob?faces=300"])
    assert result.failed_runs == 0 and result.mesh_errors == []
    assert len(result.runs) == 2 * 3 * 3
    mine = [r for r in result.runs if r["entry"] == "mine"]
    assert {r["evaluations"] for r in mine} == {200} and {r["outcome"] for r in mine} == {"budget"}
    assert pathlib.Path(result.page).read_text().count("mine") > 3
    assert {r["domain"] for r in result.runs if r["entry"] == "ga in the zone"} == {"zone"}
    for run in result.runs:
        assert run["trace"]["merit"][-1] == run["merit"]


def test_own_runs_are_repeatable():
    keep = {}
    for out in ("first", "second"):
        for run in compare({"mine": dice}, out=out, threads=1 if out == "first" else None).runs:
            keep.setdefault(run["run"], set()).add((run["digest"], run["merit"]))
    assert all(len(digests) == 1 for digests in keep.values()) and len(keep) == 3


def test_problems_in_memory(tetrahedron):
    problems = {"tetrahedron": rectilin.Problem(*tetrahedron), "again": rectilin.Mesh(*tetrahedron), "box": "shape:box"}
    result = compare({"mine": dice}, problems, runs=1)
    assert [r["mesh"] for r in result.runs] == sorted(problems)
    line = json.loads(pathlib.Path("out/meshes.jsonl").read_text().splitlines()[0])
    assert line["rectilinearity"] == pytest.approx(rectilin.measure(*tetrahedron).rectilinearity, abs=1e-6)
    assert compare({"mine": dice}, problems, runs=1).runs == result.runs  # nothing is run again
    problems["tetrahedron"] = rectilin.Problem("shape:blob", name="tetrahedron")
    with pytest.raises(rectilin.ParameterError, match="has changed"):
        compare({"mine": dice}, problems, runs=1)


def raises(problem, budget, rng):
    problem.values(rng.normal(size=(20, 4)))
    raise ValueError("no luck\nat all")


def nonsense(problem, budget, rng):
    return "a good rotation"


def no_rotation(problem, budget, rng):
    problem.values(np.ones((5, 3, 3)))


def no_search():
    pass


def test_failures_cost_their_own_runs():
    result = compare({"raises": raises, "nonsense": nonsense, "no rotation": no_rotation, "none": no_search, "mine": dice})
    assert result.failed_runs == 12
    errors = {r["entry"]: r["error"] for r in result.runs}
    assert errors["raises"].startswith("ValueError: no luck (test_compare.py, line ") and "\n" not in errors["raises"]
    assert "returned a str" in errors["nonsense"]
    assert "rotation 0 is no rotation" in errors["no rotation"]
    assert "TypeError" in errors["none"] and errors["mine"] == ""
    kept = [r for r in result.runs if r["entry"] == "raises"]
    assert all(r["evaluations"] == 20 and r["merit"] is not None for r in kept)


def test_silence_is_ended():
    def silent(problem, budget, rng):
        problem.values(np.eye(3))
        while True:
            pass

    begin = time.monotonic()
    result = compare({"silent": silent, "mine": dice}, runs=1, patience=0.5)
    assert time.monotonic() - begin < 60
    errors = {r["entry"]: r["error"] for r in result.runs}
    assert "asked for nothing" in errors["silent"] and errors["mine"] == ""


def test_other_threads_and_kept_evaluators():
    kept = []

    def elsewhere(problem, budget, rng):
        kept.append(problem)
        failures = []

        def ask():
            try:
                problem.values(np.eye(3))
            except RuntimeError as error:
                failures.append(error)

        thread = threading.Thread(target=ask)
        thread.start()
        thread.join()
        raise failures[0]

    result = compare(elsewhere, runs=2)
    assert result.failed_runs == 2 and "another thread" in result.runs[0]["error"]
    with pytest.raises(RuntimeError, match="the run is over"):
        kept[0].values(np.eye(3))


def test_progress_and_what_it_raises():
    told = []
    compare({"mine": dice}, "shape:blob?faces=20000", runs=8, budget=2000, progress=lambda *state: told.append(state))
    assert all(0 <= done <= total == 8 and isinstance(text, str) for done, total, text in told)

    def slow(problem, budget, rng):
        time.sleep(0.2)
        dice(problem, budget, rng)

    def stop(done, total, text):
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        compare({"slow": slow}, runs=200, progress=stop, out="stopped")
    done = len(pathlib.Path("stopped/runs.jsonl").read_text().splitlines())
    assert 0 < done < 200


@pytest.mark.parametrize(
    "problems, optimizers, keywords, text",
    [
        ([], "ga", {}, "no mesh"),
        ("shape:box", [], {}, "no optimizer"),
        ("shape:box", "gaa", {}, "no optimizer 'gaa'"),
        ("shape:box", {"a": "ga, grid"}, {}, "not one optimizer"),
        ("shape:box", ["ga", "ga"], {}, "given twice"),
        (["shape:box", "shape:box"], "ga", {}, "given twice"),
        ("shape:box", "ga", {"runs": 0}, "runs is 0"),
        ("shape:box", "ga", {"budget": -5}, "budget is -5"),
        ("shape:box", "ga", {"certificate": "ga"}, "proves nothing"),
        ("shape:box", "ga", {"domain": "box"}, "no domain 'box'"),
        ("shape:box", "ga", {"patience": 0}, "patience"),
    ],
)
def test_bad_plans(problems, optimizers, keywords, text):
    with pytest.raises(rectilin.ParameterError, match=text):
        compare(optimizers, problems, **keywords)


def test_bad_meshes():
    result = compare("grid", ["nowhere.off", "shape:box"], runs=1)
    assert len(result.mesh_errors) == 1 and result.mesh_errors[0].startswith("nowhere.off: ")
    with pytest.raises(TypeError):
        compare(5)
