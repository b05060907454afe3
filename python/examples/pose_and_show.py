"""Turns a mesh into its natural pose, saves it and shows it before and after.

    python3 pose_and_show.py chair.off posed.ply posed.png
"""

import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

import rectilin

source = sys.argv[1] if len(sys.argv) > 1 else "shape:stepped-pyramid?rotate=random&seed=2"
posed_file = sys.argv[2] if len(sys.argv) > 2 else "posed.ply"
picture = sys.argv[3] if len(sys.argv) > 3 else "posed.png"

mesh = rectilin.load(source)
r = rectilin.measure(mesh)
posed = mesh.vertices @ r.rotation.T  # the rows of the rotation are the new axes
rectilin.save(posed_file, posed, mesh.faces)

figure, places = plt.subplots(1, 2, figsize=(8, 4))
for axes, title, vertices in zip(places, ["as given", f"in its pose: R = {r.rectilinearity:.4f}"], [mesh.vertices, posed]):
    axes.imshow(rectilin.shaded(vertices, mesh.faces, direction=(1, 0.6, 0.8), size=600), cmap="gray")
    axes.set_title(title)
    axes.axis("off")
figure.savefig(picture, dpi=100, bbox_inches="tight")
print(posed_file, picture)
