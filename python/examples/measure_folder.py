"""Measures every mesh of a folder, with progress; what cannot be read costs its own row.

    python3 measure_folder.py meshes/ more.stl > table.csv
"""

import csv
import sys

import rectilin

sources = rectilin.sources(sys.argv[1:] or ["shape:box?rotate=random", "shape:pyramid", "shape:cylinder?sides=64", "shape:sphere"])
table = csv.writer(sys.stdout)
table.writerow(["name", "faces", "area", "R", "at most"])
for done, source in enumerate(sources):
    print(f"\r[{done}/{len(sources)}] {source:.60}", end="\033[K", file=sys.stderr)
    try:
        r = rectilin.measure(source)
    except rectilin.MeshError as error:
        print(f"\r{error}", file=sys.stderr)
        continue
    table.writerow([source, r.faces, r.area, r.rectilinearity, r.upper])
print("\r\033[K", end="", file=sys.stderr)
