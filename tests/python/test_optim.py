"""Problem, optimize(), and optimizers written in Python."""

import math
import threading

import numpy as np
import pytest
from scipy.optimize import minimize
from scipy.spatial.transform import Rotation

import rectilin
from conftest import objective, random_rotations


@pytest.fixture
def problem():
    return rectilin.Problem("shape:blob?faces=400")


def test_values_are_the_papers(tetrahedron):
    problem = rectilin.Problem(*tetrahedron)
    rotations = random_rotations(20)
    expected = [objective(*tetrahedron, r) for r in rotations]
    assert problem.values(rotations) == pytest.approx(expected, abs=1e-13)
    assert np.abs(problem.vectors @ rotations[3].T).sum() == pytest.approx(expected[3], abs=1e-13)
    assert np.linalg.norm(problem.vectors, axis=1).sum() == pytest.approx(1)


def test_forms_of_rotations(problem):
    given = Rotation.random(30, random_state=5)
    values = problem.values(given.as_matrix())
    assert values.shape == (30,)
    assert problem.values(given) == pytest.approx(values, abs=1e-13)
    assert problem.values(7 * given.as_quat()) == pytest.approx(values, abs=1e-13)
    assert problem.values(given.as_rotvec(), form="vector") == pytest.approx(values, abs=1e-13)
    quaternions = given.as_quat()
    rodrigues = quaternions[:, :3] / quaternions[:, 3:]
    assert problem.values(rodrigues, form="rodrigues") == pytest.approx(values, abs=1e-12)
    one = problem.values(given[4])
    assert isinstance(one, float) and one == values[4]
    # The paper's eqs. 35-37 turn the frame about its own x, then y, then z; the rows are the frame's axes.
    alpha, beta, gamma = 0.3, -0.8, 2.1
    expected = Rotation.from_euler("XYZ", [alpha, beta, gamma]).as_matrix().T
    turned = rectilin.domain("covering").rotation([alpha, beta, gamma])
    assert problem.values([alpha, beta, gamma], form="angles") == problem.values(turned)
    assert turned == pytest.approx(expected, abs=1e-14)


def test_cuts_are_minorants(problem):
    rotations = random_rotations(12, seed=2)
    values, gradients = problem.cuts(rotations)
    assert gradients.shape == (12, 3, 3)
    linear = np.einsum("nij,mij->nm", gradients, rotations)
    everywhere = problem.values(rotations)
    assert values == pytest.approx(everywhere, abs=1e-12)
    assert (linear <= everywhere[None, :] + 1e-12).all()
    assert np.diag(linear) == pytest.approx(everywhere, abs=1e-12)


def test_smooth_is_above_and_near(problem):
    rotation = random_rotations(1, seed=3)[0]
    value = problem.values(rotation)
    distances = [problem.smooth(rotation, width)[0] - value for width in (0.3, 0.03, 0.003)]
    assert distances[0] > distances[1] > distances[2] >= -1e-12 and distances[2] < 1e-3


def test_best_turn_is_the_best_of_many(problem):
    rotation = random_rotations(1, seed=6)[0]
    for axis in range(3):
        turned, value = problem.best_turn(rotation, axis)
        assert problem.values(turned) == pytest.approx(value, abs=1e-12)
        assert turned[axis] == pytest.approx(rotation[axis], abs=1e-12)
        others = Rotation.from_rotvec(np.eye(3)[axis] * np.linspace(0, np.pi, 500)[:, None]).as_matrix() @ rotation
        assert value <= problem.values(others).min() + 1e-12


def test_certified_optimum(problem):
    result = problem.measure(gap=1e-8)
    assert rectilin.rectilinearity(problem.values(random_rotations(5000))).max() <= result.upper
    assert result.faces == problem.faces == 400
    assert result.rectilinearity == rectilin.measure("shape:blob?faces=400", gap=1e-8).rectilinearity


def test_problem_keeps_nothing_of_the_arrays(tetrahedron):
    vertices, faces = (x.copy() for x in tetrahedron)
    problem = rectilin.Problem(vertices, faces, name="t")
    before = problem.values(np.eye(3))
    vertices[:] = 0
    faces[:] = 99
    assert problem.values(np.eye(3)) == before and problem.name == "t"


BAD_ROTATIONS = [
    (np.zeros((3, 3)), None, "the rotation is no rotation: its rows are not orthonormal"),
    (np.diag([1, 1, -1.0]), None, "not orthonormal and right-handed"),
    (np.stack([np.eye(3), 2 * np.eye(3)]), None, "rotation 1 is no rotation"),
    (np.full((3, 3), np.nan), None, "no rotation"),
    (np.zeros(4), None, "its length is 0"),
    (np.full((2, 4), np.inf), None, "rotation 0 is no rotation"),
    (np.zeros(3), None, "say form="),
    (np.zeros((5, 2)), None, r"have shape \(5, 2\)"),
    (np.zeros((5, 2)), "angles", r"have shape \(5, 2\), not \(n, 3\)"),
    ([np.nan, 0, 0], "angles", "a number is not finite"),
    (np.eye(3), "euler", "no form of rotations 'euler'"),
    (np.zeros(3), "domain", "no form of rotations 'domain'"),
    (np.zeros((2, 2, 3, 3)), None, "have shape"),
    (1.0, None, "have shape"),
]


@pytest.mark.parametrize("rotation, form, text", BAD_ROTATIONS)
def test_bad_rotations(problem, rotation, form, text):
    with pytest.raises(ValueError, match=text):
        problem.values(rotation, form=form)


def test_empty_and_wrong_types(problem):
    assert problem.values(np.zeros((0, 3, 3))).shape == (0,)
    with pytest.raises(TypeError):
        problem.values("x")
    with pytest.raises(TypeError):
        problem.values(np.eye(3, dtype=complex))
    with pytest.raises(ValueError, match="axis is 3"):
        problem.best_turn(np.eye(3), 3)
    with pytest.raises(ValueError, match="width"):
        problem.smooth(np.eye(3), 0)
    with pytest.raises(ValueError, match="one rotation is wanted"):
        problem.smooth(np.eye(3)[None], 0.1)


def test_optimize_reaches_the_optimum(problem):
    best = problem.measure()
    run = rectilin.optimize(problem, "multistart", budget=5000, seed=3)
    assert best.upper - 1e-3 < run.rectilinearity <= best.upper
    assert problem.values(run.rotation) == pytest.approx(run.value, abs=1e-12)
    trace = run.trace
    assert (np.diff(trace["value"]) < 0).all() and (np.diff(trace["evaluations"]) > 0).all()
    assert trace["value"][-1] == run.value and trace["rectilinearity"] == pytest.approx(3 / trace["value"] - 2)
    assert len({len(column) for column in trace.values()}) == 1


def test_seeds(problem):
    runs = [rectilin.optimize(problem, "ga", budget=500, seed=s).to_dict()["digest"] for s in (1, 1, 2)]
    assert runs[0] == runs[1] != runs[2]


def test_every_optimizer_is_listed_with_its_settings():
    listed = {o["name"]: o for o in rectilin.optimizers()}
    assert {"ga", "grid", "certify"} <= set(listed)
    assert any(p["name"] == "population" for p in listed["ga"]["parameters"])
    assert listed["certify"]["capabilities"]["certifies"]


def dice(problem, budget, rng):
    problem.values(rng.normal(size=(budget, 4)))


def test_own_optimizer_is_counted(problem):
    run = rectilin.optimize(problem, dice, budget=300, seed=4)
    assert run.evaluations == 300 and run.outcome == "budget" and run.optimizer == "python:dice"
    quaternions = np.random.default_rng(4).normal(size=(300, 4))
    values = problem.values(quaternions)
    assert run.value == values.min()
    trace = run.trace
    assert (trace["value"] == values[trace["evaluations"] - 1]).all()
    assert (np.minimum.accumulate(values)[trace["evaluations"] - 1] == trace["value"]).all()


def test_own_optimizer_sees_its_budget(problem):
    seen = {}

    def search(asked, budget, rng):
        seen.update(budget=budget, name=asked.name, directions=asked.directions, before=asked.best[1])
        seen["first"] = asked.values(asked.domain.lower, form="domain")
        seen["left"], seen["spent"], seen["best"] = asked.remaining, asked.evaluations, asked.best
        seen["beyond"] = asked.values(np.repeat(np.eye(3)[None], 20, axis=0))
        seen["exhausted"] = asked.exhausted

    run = rectilin.optimize(problem, search, budget=10, domain="zone")
    assert seen["budget"] == 10 and seen["left"] == 9 and seen["spent"] == 1
    assert seen["before"] == math.inf and seen["best"][1] == seen["first"]
    assert np.isfinite(seen["beyond"]).sum() == 9 and seen["exhausted"]
    assert run.evaluations == 10 and seen["directions"] == problem.directions and seen["name"] == problem.name


def test_prices(problem):
    def search(asked, budget, rng):
        asked.cuts(np.repeat(np.eye(3)[None], 3, axis=0))
        asked.smooth(np.eye(3), 0.1)
        turned, value = asked.best_turn(np.eye(3), 2)
        assert value == problem.best_turn(np.eye(3), 2)[1]

    assert rectilin.optimize(problem, search).evaluations == 3 * 2 + 5 + 20


def test_never_stopping_is_stopped(problem):
    def forever(asked, budget, rng):
        while True:
            try:
                asked.values(rng.normal(size=(7, 4)))
            except Exception:  # not even this holds it
                pass

    run = rectilin.optimize(problem, forever, budget=100)
    assert run.evaluations == 100 and run.outcome == "budget"


def test_catching_everything_is_no_way_on(problem):
    def stubborn(asked, budget, rng):
        while True:
            try:
                asked.values(rng.normal(size=(50, 4)))
            except:  # noqa: E722
                pass

    assert rectilin.optimize(problem, stubborn, budget=500).evaluations == 500
    done = rectilin.compare([problem], {"stubborn": stubborn}, runs=2, budget=500, out="stubborn")
    assert [r["evaluations"] for r in done.runs] == [500, 500] and done.failed_runs == 0


def test_seconds_end_a_run(problem):
    def forever(asked, budget, rng):
        while True:
            asked.values(rng.normal(size=(7, 4)))

    run = rectilin.optimize(problem, forever, budget=None, seconds=0.2)
    assert run.outcome == "budget" and run.evaluations > 0


def test_its_exceptions_are_the_callers(problem):
    class Odd(Exception):
        pass

    def raises(asked, budget, rng):
        raise Odd("reason")

    with pytest.raises(Odd, match="reason"):
        rectilin.optimize(problem, raises)
    with pytest.raises(ValueError, match="no rotation"):
        rectilin.optimize(problem, lambda asked, budget, rng: asked.values(np.zeros((3, 3))) and None)
    def interrupts(asked, budget, rng):
        # Not by exec() of a text: Python takes what leaves that for the end of the program, and ends so at its exit.
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        rectilin.optimize(problem, interrupts)
    with pytest.raises(RuntimeError, match="returned a float"):
        rectilin.optimize(problem, lambda asked, budget, rng: 1.5)
    with pytest.raises(TypeError):
        rectilin.optimize(problem, lambda asked: None)
    with pytest.raises(TypeError, match="a text such as"):
        rectilin.optimize(problem, 5)


def test_asking_from_elsewhere(problem):
    kept, said = [], []

    def search(asked, budget, rng):
        kept.append(asked)

        def other():
            try:
                asked.values(np.eye(3))
            except RuntimeError as error:
                said.append(str(error))

        thread = threading.Thread(target=other)
        thread.start()
        thread.join()

    run = rectilin.optimize(problem, search)
    assert "another thread" in said[0] and run.evaluations == 0 and math.isnan(run.rectilinearity)
    with pytest.raises(RuntimeError, match="the run is over"):
        kept[0].values(np.eye(3))
    with pytest.raises(RuntimeError, match="the run is over"):
        kept[0].remaining


def test_scipy_as_an_optimizer(problem):
    def nelder_mead(asked, budget, rng):
        while True:
            start = rng.uniform(asked.domain.lower, asked.domain.upper)
            minimize(asked.values, start, args=("domain",), method="Nelder-Mead")

    best = problem.measure()
    run = rectilin.optimize(problem, nelder_mead, budget=3000, seed=1)
    assert run.evaluations == 3000 and best.upper - 5e-3 < run.rectilinearity <= best.upper


def test_many_threads_at_once(problem):
    rotations = random_rotations(200)
    expected = problem.values(rotations)
    failures = []

    def work():
        for _ in range(20):
            if not np.array_equal(problem.values(rotations), expected):
                failures.append("values")
            if rectilin.optimize(problem, dice, budget=100).evaluations != 100:
                failures.append("optimize")

    threads = [threading.Thread(target=work) for _ in range(6)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert not failures
