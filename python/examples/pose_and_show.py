"""Turns a mesh into its natural pose, saves it and shows it before and after.

    python3 pose_and_show.py chair.off posed.ply posed.png
"""

import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

import rectilin

source = sys.argv[1] if len(sys.argv) > 1 else "shape:stepped-pyramid?rotate=random&seed=2"
posed_file = sys.argv[2] if len(sys.argv) > 2 else "posed.ply"
picture = sys.argv[3] if len(sys.argv) > 3 else "posed.png"

mesh = rectilin.load(source)
r = rectilin.measure(mesh)
posed = mesh.vertices @ r.rotation.T  # the rows of the rotation are the new axes
rectilin.save(posed_file, posed, mesh.faces)

figure = plt.figure(figsize=(8, 4))
for place, (title, vertices) in enumerate([("as given", mesh.vertices), (f"R = {r.rectilinearity:.4f}", posed)], 1):
    axes = figure.add_subplot(1, 2, place, projection="3d")
    axes.plot_trisurf(*vertices.T, triangles=mesh.faces, color="lightsteelblue", edgecolor="gray", linewidth=0.2)
    axes.set_box_aspect(np.ptp(vertices, axis=0))
    axes.set_title(title)
figure.savefig(picture, dpi=100, bbox_inches="tight")
print(posed_file, picture)
