"""Optimizers of scipy, and one of your own, against the library's: a page in the folder `own`.

    python3 own_optimizer.py own
"""

import sys

import numpy as np
from scipy.optimize import differential_evolution, minimize

import rectilin


def nelder_mead(problem, budget, rng):
    """scipy's simplex from random starts. Asking beyond the budget ends the run, so it need not count."""
    box = problem.domain
    while True:
        minimize(problem.values, rng.uniform(box.lower, box.upper), args=("domain",), method="Nelder-Mead")


def evolution(problem, budget, rng):
    """scipy's differential evolution. It asks for whole generations: a batch is much cheaper than its parts."""
    box = problem.domain
    differential_evolution(lambda x: problem.values(x.T, form="domain"), list(zip(box.lower, box.upper)), maxiter=budget,
                           vectorized=True, updating="deferred", polish=False, tol=0, seed=rng)


def slide(problem, budget, rng):
    """Your own: random steps from the best rotation, the shorter the longer nothing is found."""
    best, value, width = np.eye(3), np.inf, 1.0
    while not problem.exhausted:
        steps = rectilin.domain("zone").rotation(rng.normal(size=(20, 3)) * width / 2) @ best
        values = problem.values(steps)
        if values.min() < value:
            best, value = steps[values.argmin()], values.min()
        else:
            width = max(width / 2, 1e-8)


out = sys.argv[1] if len(sys.argv) > 1 else "own"
result = rectilin.compare(
    ["shape:pyramid", "shape:blob?faces=500"],
    {"ga": "ga", "Nelder-Mead (scipy)": nelder_mead, "evolution (scipy)": evolution, "slide": slide},
    runs=5,
    budget=1000,
    out=out,
)
for name in ["ga", "Nelder-Mead (scipy)", "evolution (scipy)", "slide"]:
    runs = [r for r in result.runs if r["entry"] == name]
    print(f"{name:20} mean R {np.mean([r['merit'] for r in runs]):.6f} in {np.mean([r['evaluations'] for r in runs]):.0f} evaluations")
print(result.page)
