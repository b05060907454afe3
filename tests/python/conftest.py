"""What the tests of the Python package share."""

import os
import pathlib

import numpy as np
import pytest

import rectilin


@pytest.fixture
def command():
    """The command `rectilin`, to compare with."""
    path = os.environ.get("RECTILIN_COMMAND", "")
    if not pathlib.Path(path).is_file():
        pytest.skip("RECTILIN_COMMAND does not name the command")
    return path


@pytest.fixture
def tetrahedron():
    vertices = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], float)
    faces = np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
    return vertices, faces


def objective(vertices, faces, rotation):
    """P/S by the paper's definition, written anew: three projected areas over the area."""
    a, b, c = (np.asarray(vertices, float)[np.asarray(faces)[:, k]] for k in range(3))
    vectors = np.cross(b - a, c - a) / 2
    return np.abs(vectors @ np.asarray(rotation).T).sum() / np.linalg.norm(vectors, axis=1).sum()


def random_rotations(count, seed=1):
    """Uniformly distributed matrices (by QR of normal numbers), with determinant 1."""
    rng = np.random.default_rng(seed)
    q, r = np.linalg.qr(rng.normal(size=(count, 3, 3)))
    q = q * np.sign(np.einsum("nii->ni", r))[:, None, :]
    q[np.linalg.det(q) < 0] *= -1
    return q


@pytest.fixture(autouse=True)
def doctest_names(doctest_namespace, tmp_path, monkeypatch):
    doctest_namespace.update(rectilin=rectilin, np=np, folder=str(tmp_path / "comparison"))
    monkeypatch.chdir(tmp_path)
