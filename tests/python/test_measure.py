"""measure(), measure_normals(), verify(): mathematics, the command's bits, what may be given."""

import json
import math
import subprocess
import types
import warnings

import numpy as np
import pytest

import rectilin
from conftest import objective, random_rotations

TIMES = {"seconds", "cpu_seconds", "threads"}


def test_box_is_rectilinear_in_any_pose():
    mesh = rectilin.shape("box?x=2&y=3&rotate=random&seed=5")
    result = rectilin.measure(mesh)
    assert result.rectilinearity == pytest.approx(1, abs=1e-9)
    assert result.upper >= 1 - 1e-12
    assert result.area == pytest.approx(2 * (2 * 3 + 2 + 3))
    posed = mesh.vertices @ result.rotation.T
    assert sorted(np.ptp(posed, axis=0)) == pytest.approx([1, 2, 3], abs=1e-6)


def test_bounds_hold_for_every_rotation(tetrahedron):
    result = rectilin.measure(*tetrahedron)
    values = np.array([objective(*tetrahedron, r) for r in random_rotations(3000)])
    assert (3 / values - 2).max() <= result.upper
    assert 3 / objective(*tetrahedron, result.rotation) - 2 == pytest.approx(result.rectilinearity, abs=1e-12)
    assert result.lower <= result.rectilinearity + 1e-11
    assert result.upper - result.lower < 2e-6


def test_corner_tetrahedron_beats_its_own_axes(tetrahedron):
    # S = (3 + sqrt 3) / 2. In the frame of its edges each face at the corner shows once, and the slanted face on all
    # three planes: P = 3, so that R >= S - 2.
    result = rectilin.measure(*tetrahedron)
    assert result.upper >= (3 + math.sqrt(3)) / 2 - 2
    assert 3 / objective(*tetrahedron, np.eye(3)) - 2 == pytest.approx((3 + math.sqrt(3)) / 2 - 2)


def test_narrower_gap(tetrahedron):
    result = rectilin.measure(*tetrahedron, gap=1e-9)
    assert result.upper - result.lower < 2e-9
    wide = rectilin.measure(*tetrahedron)
    assert wide.lower <= result.upper and result.lower <= wide.upper


@pytest.mark.parametrize("source", ["shape:pyramid?rotate=random&seed=3", "shape:blob?faces=2000", "shape:cylinder?sides=24"])
@pytest.mark.parametrize("options", [[], ["--optima"], ["--gap", "1e-8"], ["-o", "ga?population=20", "-b", "700", "-s", "9", "-d", "zone"]])
def test_same_bits_as_the_command(command, source, options):
    line = json.loads(subprocess.run([command, "measure", "--json", *options, source], check=True, capture_output=True).stdout)
    keywords = {
        "--optima": {"optima": True},
        "--gap": {"gap": 1e-8},
        "-o": {"optimizer": "ga?population=20", "budget": 700, "seed": 9, "domain": "zone"},
    }[options[0]] if options else {}
    mesh = rectilin.load(source)
    for given in [(mesh,), (mesh.vertices, mesh.faces), (source,)]:
        here = rectilin.measure(*given, **keywords).to_dict()
        for key, value in here.items():
            if key not in TIMES:
                assert value == line[key], key


def test_any_number_of_threads_gives_the_same_bits():
    digests = {rectilin.measure("shape:blob?faces=3000", threads=n).to_dict()["digest"] for n in (1, 2, 3)}
    assert len(digests) == 1


def test_optima():
    result = rectilin.measure("shape:cut-cube", optima=True)
    assert result.optima
    for optimum in result.optima:
        assert optimum["rectilinearity"] == pytest.approx(result.rectilinearity, abs=2e-6)
    assert rectilin.measure("shape:cut-cube").optima == []


def test_proof_is_accepted_and_forgery_is_not():
    mesh = rectilin.shape("pyramid?rotate=random")
    result = rectilin.measure(mesh, proof=True)
    verdict = rectilin.verify(result.proof, mesh)
    assert verdict and verdict.lower <= result.rectilinearity <= verdict.upper
    forged = json.loads(result.proof)
    forged["lower"] *= 1.01
    refused = rectilin.verify(json.dumps(forged), mesh)
    assert not refused and refused.reason
    assert "another mesh" in rectilin.verify(result.proof, "shape:box").reason
    assert not rectilin.verify("nonsense", mesh)


def test_proof_of_the_command(command, tmp_path):
    proof = tmp_path / "proof.json"
    subprocess.run([command, "measure", "--proof", proof, "shape:pyramid"], check=True, capture_output=True)
    assert rectilin.measure("shape:pyramid", proof=True).proof == proof.read_text()


@pytest.mark.parametrize("dtype", [np.float64, np.float32, np.int32, np.int64, ">f8", np.float16])
def test_types_of_vertices(tetrahedron, dtype):
    vertices, faces = tetrahedron
    assert rectilin.measure(vertices.astype(dtype), faces).rectilinearity == rectilin.measure(vertices, faces).rectilinearity


@pytest.mark.parametrize("dtype", [np.int8, np.uint8, np.int16, np.uint16, np.int32, np.uint32, np.int64, np.uint64, ">i4"])
def test_types_of_faces(tetrahedron, dtype):
    vertices, faces = tetrahedron
    assert rectilin.measure(vertices, faces.astype(dtype)).rectilinearity == rectilin.measure(vertices, faces).rectilinearity


def test_layouts(tetrahedron):
    vertices, faces = tetrahedron
    expected = rectilin.measure(vertices, faces).to_dict()["digest"]
    wide = np.zeros((4, 6))
    wide[:, ::2] = vertices
    packed = np.zeros((4, 3), dtype=[("pad", "u1"), ("x", "f8")])
    packed["x"] = vertices
    readonly = vertices.copy()
    readonly.flags.writeable = False
    for given in [wide[:, ::2], np.asfortranarray(vertices), packed["x"], readonly, vertices.tolist(), vertices[::-1][::-1]]:
        assert rectilin.measure(given, faces).to_dict()["digest"] == expected
    for given in [np.asfortranarray(faces), faces.tolist(), faces[::-1][::-1]]:
        assert rectilin.measure(vertices, given).to_dict()["digest"] == expected


def test_meshes_of_other_packages(tetrahedron):
    vertices, faces = tetrahedron
    expected = rectilin.measure(vertices, faces).to_dict()["digest"]
    trimesh = types.SimpleNamespace(vertices=vertices, faces=faces)
    open3d = types.SimpleNamespace(vertices=vertices.tolist(), triangles=faces.tolist())
    meshio = types.SimpleNamespace(points=vertices, cells_dict={"line": [[0, 1]], "triangle": faces})
    for mesh in [trimesh, open3d, meshio, rectilin.Mesh(vertices, faces), rectilin.Mesh(trimesh)]:
        assert rectilin.measure(mesh).to_dict()["digest"] == expected
    quads = types.SimpleNamespace(points=vertices, cells_dict={"quad": [[0, 1, 2, 3]]})
    with pytest.raises(ValueError, match="quad"):
        rectilin.measure(quads)


BAD_VERTICES = [
    (np.zeros((4, 2)), ValueError, r"V has shape \(4, 2\), not \(n, 3\)"),
    (np.zeros(12), ValueError, r"V has shape \(12,\)"),
    (np.zeros((2, 2, 3)), ValueError, r"V has shape \(2, 2, 3\)"),
    (np.zeros((4, 3), complex), TypeError, "V holds complex128"),
    (np.zeros((4, 3), bool), TypeError, "V holds bool"),
    (np.full((4, 3), "x"), TypeError, "V holds <U1"),
    (np.full((4, 3), None), TypeError, "V holds object"),
    (np.array([[0, 0, 0], [1, 0, 0], [0, np.nan, 0], [0, 0, 1]]), ValueError, r"V\[2\] is not finite"),
    (np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, -np.inf, 1]]), ValueError, r"V\[3\] is not finite"),
    ([], ValueError, r"V has shape \(0,\)"),
    (object(), ValueError, "V has shape"),
    (None, ValueError, "V has shape"),
]


@pytest.mark.parametrize("vertices, error, text", BAD_VERTICES)
def test_bad_vertices(tetrahedron, vertices, error, text):
    with pytest.raises(error, match=text):
        rectilin.measure(vertices, tetrahedron[1])


BAD_FACES = [
    (np.zeros((4, 4), int), ValueError, r"F has shape \(4, 4\), not \(m, 3\)"),
    (np.zeros((4, 3)), TypeError, "F holds float64, not integers"),
    (np.array([[0, 1, 4]]), ValueError, r"F\[0, 2\] is 4, but there are 4 vertices"),
    (np.array([[0, 1, 2], [0, -1, 2]]), ValueError, r"F\[1, 1\] is -1"),
    (np.array([[0, -1, 2]], np.int8), ValueError, r"F\[0, 1\] is -1"),
    (np.array([[2**32, 0, 1]]), ValueError, r"F\[0, 0\] is 4294967296"),
    (np.array([[2**64 - 1, 0, 1]], np.uint64), ValueError, r"F\[0, 0\] is 18446744073709551615"),
    (np.zeros((0, 3), int), rectilin.MeshError, "area is zero"),
    (np.zeros((2, 3), int), rectilin.MeshError, "area is zero"),
    ([], ValueError, r"F has shape \(0,\)"),
]


@pytest.mark.parametrize("faces, error, text", BAD_FACES)
def test_bad_faces(tetrahedron, faces, error, text):
    with pytest.raises(error, match=text):
        rectilin.measure(tetrahedron[0], faces)


def test_bad_calls(tetrahedron):
    with pytest.raises(TypeError, match="a mesh is wanted"):
        rectilin.measure(tetrahedron[0])
    with pytest.raises(rectilin.MeshError, match="nowhere.off: "):
        rectilin.measure("nowhere.off")
    with pytest.raises(rectilin.ParameterError, match="did you mean 'pyramid'"):
        rectilin.measure("shape:pyramit")


@pytest.mark.parametrize(
    "keywords, text",
    [
        ({"gap": -1}, "gap is -1"),
        ({"gap": math.nan}, "gap is nan"),
        ({"optimizer": "gaa"}, "no optimizer 'gaa'"),
        ({"optimizer": "ga?x=1"}, "x"),
        ({"optimizer": "ga", "optima": True}, "need the optimizer certify"),
        ({"domain": "zones"}, "did you mean 'zone'"),
        ({"seed": -1}, "seed is -1"),
        ({"seed": 1.5}, "seed is 1.5"),
        ({"budget": 0}, "budget is 0"),
        ({"seconds": -1}, "seconds is -1"),
        ({"threads": 0}, "threads is 0"),
    ],
)
def test_bad_settings(tetrahedron, keywords, text):
    with pytest.raises(rectilin.ParameterError, match=text):
        rectilin.measure(*tetrahedron, **keywords)


def test_errors_are_the_commands(command, tmp_path):
    bad = tmp_path / "bad.off"
    bad.write_text("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n")
    said = subprocess.run([command, "measure", bad], capture_output=True, text=True).stderr.splitlines()[0]
    with pytest.raises(rectilin.MeshError) as error:
        rectilin.load(bad)
    assert said == "rectilin: " + str(error.value)


def test_what_was_left_out_is_said(command, tmp_path):
    lossy = tmp_path / "lossy.off"
    rectilin.save(lossy, "shape:box")
    lossy.write_text(lossy.read_text() + "3 0 1 2\n")
    said = subprocess.run([command, "measure", lossy], check=True, capture_output=True, text=True).stderr.splitlines()[0]
    for read in (rectilin.load, rectilin.measure, rectilin.Problem, rectilin.Mesh, rectilin.silhouette_area):
        with pytest.warns(UserWarning) as warned:
            read(lossy)
        assert ["rectilin: " + str(w.message) for w in warned] == [said]
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        rectilin.load("shape:box")
        with pytest.raises(UserWarning, match="7 bytes of data behind"):
            rectilin.load(lossy)
    compared = rectilin.compare(str(lossy), "random", runs=1, budget=10, out="lossy")
    assert ["rectilin: " + line for line in compared.losses] == [said]


def test_normals():
    assert rectilin.measure_normals(np.eye(3)).rectilinearity == pytest.approx(1)
    rotation = random_rotations(1, seed=4)[0]
    rng = np.random.default_rng(2)
    normals = np.repeat(rotation, 50, axis=0) * rng.choice([-1, 1], (150, 1)) * rng.uniform(0.1, 9, (150, 1))
    noisy = normals / np.linalg.norm(normals, axis=1)[:, None] + rng.normal(scale=0.01, size=normals.shape)
    result = rectilin.measure_normals(noisy)
    # Each axis found is one of the true ones within the noise.
    assert np.abs(result.rotation @ rotation.T).max(axis=1) == pytest.approx(1, abs=1e-4)


def test_normals_of_a_mesh_give_its_rectilinearity(tetrahedron):
    vertices, faces = tetrahedron
    a, b, c = (vertices[faces[:, k]] for k in range(3))
    vectors = np.cross(b - a, c - a) / 2
    result = rectilin.measure_normals(vectors, np.linalg.norm(vectors, axis=1))
    mesh = rectilin.measure(vertices, faces)
    assert result.rectilinearity == pytest.approx(mesh.rectilinearity, abs=1e-9)
    assert result.area == pytest.approx(mesh.area)


@pytest.mark.parametrize(
    "normals, weights, text",
    [
        (np.zeros((1, 3)), None, "normal 0 is zero"),
        ([[0, 0, 1], [0, np.nan, 0]], None, "normal 1 is zero or not finite"),
        (np.eye(3), [1, 2], "3 numbers"),
        (np.eye(3), [1, -2, 1], "weight 1 is negative"),
        (np.eye(3), [0, 0, 0], "no weight"),
        (np.zeros((0, 3)), None, "no weight"),
        (np.zeros((3, 2)), None, "N has shape"),
    ],
)
def test_bad_normals(normals, weights, text):
    with pytest.raises(ValueError, match=text):
        rectilin.measure_normals(normals, weights)


def test_normals_from_a_file(command, tmp_path):
    cloud = tmp_path / "cloud.ply"
    rng = np.random.default_rng(3)
    rows = np.concatenate([rng.normal(size=(40, 3)), random_rotations(40, 7)[:, 0], rng.uniform(1, 2, (40, 1))], axis=1)
    header = "ply\nformat ascii 1.0\nelement vertex 40\n" + "".join(
        f"property double {name}\n" for name in ["x", "y", "z", "nx", "ny", "nz", "weight"]) + "end_header\n"
    cloud.write_text(header + "\n".join(" ".join(map(repr, map(float, row))) for row in rows) + "\n")
    normals, weights = rectilin.read_normals(cloud)
    assert np.array_equal(normals, rows[:, 3:6]) and np.array_equal(weights, rows[:, 6])
    binary = tmp_path / "binary.ply"
    binary.write_bytes(header.replace("ascii", "binary_big_endian").encode() + rows.astype(">f8").tobytes())
    again, weights_again = rectilin.read_normals(binary)
    assert np.array_equal(again, normals) and np.array_equal(weights_again, weights)
    here = rectilin.measure_normals(normals, weights)
    line = json.loads(subprocess.run([command, "measure", "--normals", "--json", cloud], check=True, capture_output=True).stdout)
    for key in ["rectilinearity", "upper", "rotation", "digest", "area"]:
        assert here.to_dict()[key] == line[key]
    with pytest.raises(rectilin.MeshError, match="no normals"):
        mesh = tmp_path / "mesh.ply"
        rectilin.save(mesh, "shape:box")
        rectilin.read_normals(mesh)


def test_mesh_object():
    mesh = rectilin.shape("box")
    assert not mesh.vertices.flags.writeable and not mesh.faces.flags.writeable
    assert mesh.faces.dtype == np.uint32 and mesh.report["vertices"] == 8
    vertices = mesh.vertices
    del mesh
    assert vertices.sum() is not None and np.ptp(vertices) == 1  # the array keeps the mesh


@pytest.mark.parametrize("ending", ["off", "obj", "ply", "stl"])
def test_save_and_load(tmp_path, tetrahedron, ending):
    file = tmp_path / f"mesh.{ending}"
    rectilin.save(file, *tetrahedron)
    again = rectilin.load(file)
    assert again.vertices[again.faces] == pytest.approx(tetrahedron[0][tetrahedron[1]])


def test_save_fails_with_reasons(tmp_path, tetrahedron):
    with pytest.raises(rectilin.MeshError):
        rectilin.save(tmp_path / "mesh.xyz", *tetrahedron)
    with pytest.raises(OSError, match="cannot be written"):
        rectilin.save(tmp_path / "nowhere" / "mesh.off", *tetrahedron)
