"""Which shapes of a collection are most like a mesh, and which are there twice?

    python3 search_collection.py [DATABASE QUERY FOLDER...]
"""

import sys

import rectilin

if len(sys.argv) > 3:
    database, query, *sources = sys.argv[1:]
else:  # shapes that it makes itself: boxes, rings and stairs, and one of them twice
    database, query = "shapes.db", "shape:torus?minor=0.36&rotate=random"
    sources = [f"shape:{s}" for s in ["box", "box?x=2", "torus?minor=0.3", "torus?minor=0.4", "stairs", "stairs?rotate=random"]]

done = rectilin.index(sources, database, progress=lambda k, n, text: print(f"{k} of {n}: {text}", file=sys.stderr))
print(f"{done['added']} described now, {done['unchanged']} were there, {len(done['errors'])} have no signature")

shapes = rectilin.Database(database)  # in memory: one for many searches
found = shapes.search(query, count=3)
for name, distance in zip(found.names, found.distances):
    print(f"{distance:.3f}  {name}")

rectilinear = shapes.rectilinearity > 0.99  # arrays of one entry a shape choose what may be found
print("the most alike of those at right angles:", shapes.search(query, keep=rectilinear, count=1).names[0])

for group in rectilin.duplicates(database)["groups"]:
    print("one shape:", ", ".join(group["names"]))
