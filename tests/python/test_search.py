"""index(), Database, search(), duplicates()."""

import json
import os
import signal
import subprocess
import sys
import textwrap
import threading

import numpy as np
import pytest

import rectilin
from conftest import random_rotations

SHAPES = ["box", "box?x=2&y=3", "lshape", "pyramid", "sphere?subdivisions=3", "stairs", "torus", "cylinder"]


@pytest.fixture
def folder(tmp_path):
    """A folder of meshes in random poses."""
    there = tmp_path / "parts"
    there.mkdir()
    for i, (shape, turn) in enumerate(zip(SHAPES, random_rotations(len(SHAPES), seed=5))):
        mesh = rectilin.shape(shape)
        rectilin.save(there / f"{i}.ply", (i + 1) * mesh.vertices @ turn.T, mesh.faces)
    return there


@pytest.fixture
def file(folder, tmp_path):
    out = tmp_path / "parts.db"
    assert rectilin.index(folder, out, descriptor="d2+0.5*shd")["added"] == len(SHAPES)
    return out


def test_index_is_brought_up_to_date(folder, file):
    (folder / "0.ply").rename(folder / "moved.ply")
    (folder / "1.ply").unlink()
    (folder / "broken.off").write_text("OFF\n1 2\n")
    told = []
    done = rectilin.index([folder], file, progress=lambda *a: told.append(a))
    errors = done.pop("errors")
    assert done == {"added": 0, "changed": 0, "moved": 1, "copied": 0, "removed": 1, "unchanged": len(SHAPES) - 2}
    assert len(errors) == 1 and "broken.off" in errors[0] and "\n" not in errors[0]
    database = rectilin.Database(file)
    assert len(database) == len(SHAPES) - 1 and database.descriptor == "d2+0.5*shd"
    assert list(database.failed.values()) == errors
    with pytest.raises(KeyError, match="broken.off"):
        database.search(like=next(iter(database.failed)))
    for done, total, text in told:
        assert 0 < done <= total and isinstance(text, str)


def test_members_are_arrays(file):
    database = rectilin.Database(str(file))
    assert sorted(database.names) == database.names and len(database.names) == len(SHAPES)
    for i, source in enumerate(database.sources):
        mesh = rectilin.load(source)
        assert database.faces[i] == len(mesh.faces)
        assert database.size[i] == pytest.approx(np.ptp(mesh.vertices, axis=0).max())
        assert database.rectilinearity[i] == pytest.approx(rectilin.measure(mesh).rectilinearity, abs=2e-6)


def test_distances_are_those_of_the_signatures(file):
    """Ranked by comparing the query with every member, one after the other."""
    database = rectilin.Database(file)
    mesh = rectilin.shape("box?x=1.5&y=3&rotate=random")
    query = rectilin.describe(mesh, descriptor=database.descriptor)
    distances = np.array([rectilin.distance(query, database.signature(i), descriptor=database.descriptor) for i in range(len(database))])
    found = database.search(mesh.vertices, mesh.faces, count=5)
    assert len(found) == 5 and found.members.dtype == np.int64
    assert (found.members == np.argsort(distances, kind="stable")[:5]).all()
    assert found.distances == pytest.approx(np.sort(distances)[:5], rel=1e-12)
    assert found.names == [database.names[i] for i in found.members]
    far = rectilin.search(file, mesh, keep=distances > np.median(distances), count=100)
    assert sorted(far.members) == sorted(np.flatnonzero(distances > np.median(distances)))


def test_a_turned_scaled_moved_member_finds_itself(file):
    database = rectilin.Database(file)
    turn = random_rotations(1, seed=8)[0]
    for i, source in enumerate(database.sources):
        mesh = rectilin.load(source)
        found = database.search(0.01 * mesh.vertices @ turn.T + 7, mesh.faces, count=1)
        assert found.members[0] == i
        assert i not in database.search(like=i, count=100).members
        assert i not in database.search(like=database.names[i], count=100, collection=True).members


def test_the_commands_results(file, command):
    for arguments, keywords in [([], {}), (["--collection"], {"collection": True}), (["--approximate"], {"approximate": True})]:
        line = subprocess.run([command, "search", str(file), "shape:lshape?x=2", "-n", "4", "--json", *arguments], check=True, capture_output=True).stdout
        there = json.loads(line)["results"]
        here = rectilin.search(file, "shape:lshape?x=2", count=4, **keywords)
        assert here.names == [r["name"] for r in there]
        assert here.distances.tolist() == [r["distance"] for r in there]


def test_duplicates(folder, file):
    mesh = rectilin.load(folder / "2.ply")
    rectilin.save(folder / "copy.stl", 3 * mesh.vertices @ random_rotations(1, seed=2)[0].T, mesh.faces)
    blob = rectilin.shape("blob?faces=2000&seed=3")  # has no mirror plane
    for name, sign in [("right.ply", 1), ("left.ply", -1)]:
        faces = blob.faces if sign > 0 else blob.faces[:, ::-1]
        rectilin.save(folder / name, blob.vertices * [1, 1, sign] @ random_rotations(1, seed=4)[0].T, faces)
    rectilin.index(folder, file)
    found = rectilin.duplicates(file)
    assert found["errors"] == [] and found["pairs_looked_at"] > 0
    groups = [{os.path.basename(name) for name in group["names"]} for group in found["groups"]]
    assert {"2.ply", "copy.stl"} in groups
    pair = found["groups"][groups.index({"2.ply", "copy.stl"})]["evidence"][0]
    assert pair["surface_distance"] < 1e-3 and not pair["same_bytes"] and pair["scale"] == pytest.approx(3, rel=1e-3)
    halves = found["groups"][groups.index({"left.ply", "right.ply"})]
    assert halves["mirrored"] == [False, True] and halves["evidence"][0]["mirrored"]


def test_threads_share_a_database(file):
    database = rectilin.Database(file)
    expected = database.search(like=0, count=3).distances.tolist()
    wrong = []

    def work():
        for _ in range(20):
            if database.search(like=0, count=3, threads=1).distances.tolist() != expected:
                wrong.append(1)

    threads = [threading.Thread(target=work) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert not wrong


def test_progress_that_raises_ends_the_indexing(folder, tmp_path):
    for i in range(60):  # long enough to be told of
        rectilin.save(folder / f"more{i}.off", rectilin.shape(f"blob?faces=3000&seed={i}"))

    def progress(done, total, text):
        raise OverflowError("enough")

    with pytest.raises(OverflowError, match="enough"):
        rectilin.index(folder, tmp_path / "slow.db", descriptor="gsmd", threads=1, progress=progress)
    done = rectilin.index(folder, tmp_path / "slow.db")
    assert done["added"] + done["unchanged"] == 60 + len(SHAPES) and done["errors"] == []


def test_ctrl_c_stops_and_the_same_call_goes_on(tmp_path):
    program = textwrap.dedent("""
        import sys, rectilin
        sources = [f"shape:blob?faces=4000&seed={i}" for i in range(200)]
        show = (lambda *a: print(*a, flush=True)) if sys.argv[1:] else None
        try:
            print(rectilin.index(sources, "many.db", descriptor="gsmd", progress=show)["unchanged"])
        except KeyboardInterrupt:
            print("stopped", flush=True)
    """)
    with subprocess.Popen([sys.executable, "-c", program, "show"], cwd=tmp_path, stdout=subprocess.PIPE, text=True) as running:
        running.stdout.readline()
        running.send_signal(signal.SIGINT)
        assert running.stdout.read().endswith("stopped\n")
    kept = len(rectilin.Database(tmp_path / "many.db"))
    assert 0 < kept < 200
    again = subprocess.run([sys.executable, "-c", program], cwd=tmp_path, capture_output=True, text=True, check=True)
    assert int(again.stdout) == kept and len(rectilin.Database(tmp_path / "many.db")) == 200


@pytest.mark.parametrize(
    "keywords, error, text",
    [
        ({}, rectilin.ParameterError, "like="),
        ({"V": "shape:box", "like": 0}, rectilin.ParameterError, "like="),
        ({"like": "nothing"}, KeyError, "no member 'nothing'"),
        ({"like": 99}, IndexError, "there are 8 members"),
        ({"like": -1}, ValueError, "like"),
        ({"like": 1.5}, (ValueError, TypeError), "like"),
        ({"like": 0, "count": 0}, ValueError, "count"),
        ({"like": 0, "keep": [True]}, ValueError, "each of the 8"),
        ({"like": 0, "keep": np.ones(8)}, TypeError, "bools"),
        ({"like": 0, "keep": np.ones((8, 1), bool)}, ValueError, "each of the 8"),
        ({"like": 0, "threads": 0}, ValueError, "threads"),
        ({"V": np.zeros((3, 3)), "F": [[0, 1, 2]]}, rectilin.MeshError, "area"),
        ({"V": np.full((3, 3), np.nan), "F": [[0, 1, 2]]}, ValueError, "not finite"),
        ({"V": np.eye(3), "F": [[0, 1, 3]]}, ValueError, ""),
        ({"V": 7}, TypeError, "a mesh is wanted"),
    ],
)
def test_bad_queries(file, keywords, error, text):
    database = rectilin.Database(file)
    for search in [database.search, lambda *a, **k: rectilin.search(database, *a, **k), lambda *a, **k: rectilin.search(file, *a, **k)]:
        with pytest.raises(error, match=text) as caught:
            search(**keywords)
        assert "\n" not in str(caught.value)


def test_huge_counts_are_all(file):
    for collection in [False, True]:
        assert len(rectilin.search(file, like=0, count=2**63, collection=collection)) == len(SHAPES) - 1
    nobody = rectilin.search(file, like=0, keep=np.zeros(len(SHAPES), bool))
    assert len(nobody) == 0 and nobody.distances.shape == (0,) and nobody.members.shape == (0,)


def test_bad_files(tmp_path, file):
    (tmp_path / "text.db").write_text("no database\n" * 100)
    for bad in ["none.db", "text.db"]:
        for call in [rectilin.Database, rectilin.duplicates, lambda f: rectilin.search(f, "shape:box")]:
            with pytest.raises(OSError, match=bad):
                call(tmp_path / bad)
    assert not (tmp_path / "none.db").exists()
    with pytest.raises(OSError):
        rectilin.index("shape:box", tmp_path / "no folder" / "x.db")
    with pytest.raises(rectilin.ParameterError, match="d2"):
        rectilin.index("shape:box", file, descriptor="d1")
    with pytest.raises(rectilin.ParameterError):
        rectilin.index("shape:box", tmp_path / "new.db", descriptor="nothing")
    with pytest.raises(TypeError):
        rectilin.index([1], file)
    with pytest.raises(TypeError):
        rectilin.index(3, file)
    with pytest.raises(TypeError, match="callable"):
        rectilin.index("shape:box", file, progress=3)
    with pytest.raises(TypeError):
        rectilin.Database(7)
    with pytest.raises(rectilin.ParameterError, match="tolerance"):
        rectilin.duplicates(file, tolerance=-1)
    assert len(rectilin.Database(file)) == len(SHAPES)
