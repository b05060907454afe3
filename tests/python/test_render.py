"""render(), shaded(), silhouette_area(), views()."""

import json
import math
import subprocess

import numpy as np
import pytest

import rectilin
from conftest import random_rotations


def test_silhouette_of_a_box_is_the_sum_of_its_faces_seen():
    directions = random_rotations(20, seed=3)[:, 2]
    lower, upper = rectilin.silhouette_area("shape:box?x=1&y=2&z=3", directions=7 * directions)
    expected = np.abs(directions) @ [2 * 3, 1 * 3, 1 * 2]
    assert (lower <= expected * (1 + 1e-12)).all() and (expected <= upper * (1 + 1e-12)).all()
    assert (upper - lower <= 1e-6 * upper * 1.01).all()


def test_same_bits_as_the_command(command):
    done = subprocess.run([command, "silhouette", "--json", "--views", "18", "shape:torus"], check=True, capture_output=True)
    lines = [json.loads(line) for line in done.stdout.splitlines()]
    lower, upper = rectilin.silhouette_area("shape:torus", directions=rectilin.views(18))
    text = json.dumps(lines)
    for value in [*lower, *upper]:
        assert repr(float(value)) in text


def test_depth_picture_has_the_silhouettes_area():
    mesh = rectilin.shape("stairs?rotate=random")
    picture = rectilin.render(mesh, direction=(1, 2, 3), size=512)
    corners = mesh.vertices[mesh.faces].reshape(-1, 3)
    centre = (corners.min(axis=0) + corners.max(axis=0)) / 2
    radius = np.linalg.norm(corners - centre, axis=1).max()
    area = (picture > 0).sum() * (2 * radius / 512) ** 2
    lower, upper = rectilin.silhouette_area(mesh, directions=(1, 2, 3))
    assert area == pytest.approx((lower + upper) / 2, rel=0.01)
    assert picture.dtype == np.uint16


def test_opposite_directions_mirror():
    front, back = (rectilin.render("shape:lshape?rotate=random", direction=d, size=64) > 0 for d in [(1, 2, 3), (-1, -2, -3)])
    assert (front == back[:, ::-1]).all()


def test_rotation_is_the_pictures_frame():
    mesh = rectilin.shape("lshape?rotate=random")
    rotation = rectilin.measure(mesh).rotation
    turned = rectilin.render(mesh.vertices @ rotation.T, mesh.faces, rotation=np.eye(3), size=128)
    same = rectilin.render(mesh, rotation=rotation, size=128)
    assert abs((turned > 0).sum() - (same > 0).sum()) < 0.15 * (same > 0).sum()


def test_shaded():
    picture = rectilin.shaded("shape:box", direction=(1, 1, 1), size=100)
    assert picture.shape == (100, 100) and picture.dtype == np.uint8 and picture[0, 0] == 255 and picture[50, 50] < 255


@pytest.mark.parametrize(
    "function, keywords, text",
    [
        ("render", {"size": 0}, "1 to 16384 pixels"),
        ("render", {"direction": (0, 0, 0)}, "zero or not finite"),
        ("render", {"direction": (0, math.nan, 0)}, "zero or not finite"),
        ("render", {"direction": (1, 0)}, "three numbers"),
        ("render", {"rotation": 2 * np.eye(3)}, "no rotation"),
        ("render", {"rotation": np.eye(3), "direction": (1, 0, 0)}, "not both"),
        ("silhouette_area", {"directions": np.zeros((2, 3))}, ""),
        ("silhouette_area", {"directions": np.zeros((2, 2))}, "shape"),
        ("silhouette_area", {"tolerance": 2}, "tolerance"),
    ],
)
def test_bad_input(function, keywords, text):
    with pytest.raises(ValueError, match=text):
        getattr(rectilin, function)("shape:box", **keywords)


def test_views():
    assert np.linalg.norm(rectilin.views(66), axis=1) == pytest.approx(1)
    with pytest.raises(ValueError):
        rectilin.views(7)
