"""The installed package, by CMake and by pip, each in a clean prefix."""

import importlib.util
import os
import pathlib
import subprocess
import sys

import pytest

ROOT = pathlib.Path(__file__).parents[2]
TRY = """
import pathlib, sys
import rectilin
home = pathlib.Path(rectilin.__file__).parent
assert sys.argv[1] in str(home), home
assert (home / "py.typed").exists() and (home / "__init__.pyi").exists()
r = rectilin.measure("shape:box?rotate=random")
assert abs(r.rectilinearity - 1) < 1e-9
print(rectilin.__version__)
"""


def version():
    text = (ROOT / "CMakeLists.txt").read_text()
    return text.split("project(rectilin VERSION ")[1].split()[0]


def use(folder, prefix, tmp_path):
    environment = {key: value for key, value in os.environ.items() if key != "PYTHONPATH"}
    environment["PYTHONPATH"] = str(folder)
    done = subprocess.run([sys.executable, "-c", TRY, str(prefix)], cwd=tmp_path, env=environment, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert done.stdout.strip() == version()


@pytest.fixture
def build():
    path = os.environ.get("RECTILIN_BUILD", "")
    if not pathlib.Path(path, "CMakeCache.txt").is_file():
        pytest.skip("RECTILIN_BUILD does not name the build tree")
    return path


def test_cmake_component(build, tmp_path):
    prefix = tmp_path / "prefix"
    subprocess.run([os.environ["RECTILIN_CMAKE"], "--install", build, "--component", "python", "--prefix", prefix],
                   check=True, capture_output=True)
    modules = [path for path in prefix.rglob("*") if path.is_file()]
    assert {path.parent.name for path in modules} == {"rectilin"} and len(modules) == 4  # nothing of the C++ package
    use(modules[0].parents[1], prefix, tmp_path)


def test_pip(build, tmp_path):
    for module in ["pip", "setuptools", "wheel"]:
        if importlib.util.find_spec(module) is None:
            pytest.skip(f"{module} is not installed")
    target = tmp_path / "packages"
    # RECTILIN_BUILD_DIR= (empty) has pip build all by itself, which takes minutes.
    environment = {"RECTILIN_BUILD_DIR": build, **os.environ, "PIP_NO_INDEX": "1", "PIP_DISABLE_PIP_VERSION_CHECK": "1"}
    if not environment["RECTILIN_BUILD_DIR"]:
        environment.pop("RECTILIN_BUILD_DIR")
    environment.pop("PYTHONPATH", None)
    done = subprocess.run([sys.executable, "-m", "pip", "install", "--no-build-isolation", "--no-deps", "--target", target, ROOT],
                          env=environment, cwd=tmp_path, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
    use(target, target, tmp_path)
