"""pose(), resolve_axes(), describe() and distance()."""

import json
import subprocess

import numpy as np
import pytest

import rectilin
from conftest import random_rotations


def test_rectilinear_pose_of_a_box_stands_upright():
    mesh = rectilin.shape("box?x=1&y=2&z=3&rotate=random&seed=4")
    found = rectilin.pose(mesh, method="rectilinear")
    posed = found.normalized(mesh)
    assert np.linalg.norm(posed.vertices, axis=1).max() == pytest.approx(1)
    assert sorted(np.ptp(posed.vertices, axis=0) / found.scale) == pytest.approx([1, 2, 3])
    assert posed.vertices == pytest.approx(found.scale * (mesh.vertices - found.centre) @ found.rotation.T)


def test_the_commands_pose(command):
    line = json.loads(subprocess.run([command, "pose", "--json", "shape:stairs?rotate=random"], check=True, capture_output=True).stdout)
    here = rectilin.pose("shape:stairs?rotate=random").to_dict()
    for key in ["method", "chosen", "reason", "centre", "scale", "uniqueness", "confidence"]:
        assert here[key] == line[key]


def test_resolved_axes_turn_with_the_mesh():
    mesh = rectilin.shape("lshape?x=3")
    frame, resolved = rectilin.resolve_axes(mesh, rotation=np.eye(3), rule="definite")
    assert resolved
    turn = random_rotations(1, seed=9)[0]
    turned, _ = rectilin.resolve_axes(mesh.vertices @ turn.T, mesh.faces, rotation=turn.T, rule="definite")
    assert turned @ turn == pytest.approx(frame, abs=1e-9)


def test_signatures_do_not_depend_on_the_pose():
    a, b, c = (rectilin.describe(f"shape:{s}") for s in ["box?y=3&rotate=random&seed=1", "box?y=3&rotate=random&seed=2", "torus"])
    assert rectilin.distance(a, b) < 0.2 * rectilin.distance(a, c)
    assert rectilin.distance(a, c) == rectilin.distance(c, a)


def test_bad_input():
    with pytest.raises(rectilin.ParameterError):
        rectilin.pose("shape:box", method="upright")
    with pytest.raises(rectilin.ParameterError, match="no rule of axes 'x'"):
        rectilin.resolve_axes("shape:box", rotation=np.eye(3), rule="x")
    with pytest.raises(rectilin.ParameterError):
        rectilin.describe("shape:box", descriptor="nothing")
    box = rectilin.describe("shape:box")
    for bad in [box[:-1], box.astype(float), box[None], np.repeat(box, 2)[::2]]:
        with pytest.raises(ValueError, match="no signature"):
            rectilin.distance(bad, box)
