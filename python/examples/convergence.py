"""How fast does an optimizer come near? Plots the gap to the certified optimum over evaluations.

    python3 convergence.py chair.off convergence.png
"""

import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

import rectilin

source = sys.argv[1] if len(sys.argv) > 1 else "shape:blob?faces=2000"
picture = sys.argv[2] if len(sys.argv) > 2 else "convergence.png"

problem = rectilin.Problem(source)
upper = problem.measure(gap=1e-9).upper  # no rotation has more

figure, axes = plt.subplots(figsize=(6, 4))
for color, optimizer in zip(["C0", "C1", "C2"], ["random", "ga", "multistart"]):
    for seed in range(5):
        trace = rectilin.optimize(problem, optimizer, budget=5000, seed=seed).trace
        axes.step(trace["evaluations"], upper - trace["rectilinearity"], where="post", color=color, alpha=0.7,
                  label=optimizer if seed == 0 else None)
axes.set(xscale="log", yscale="log", xlabel="evaluations", ylabel="gap to the certified optimum", title=problem.name)
axes.legend()
figure.savefig(picture, dpi=100, bbox_inches="tight")
print(picture)
