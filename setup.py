"""pip install . : has CMake build and install the Python package. Without network: pip install --no-build-isolation .

RECTILIN_CMAKE_ARGS in the environment holds further arguments for CMake; RECTILIN_BUILD_DIR a build folder to use and keep:
one that is there, such as build/release, is used with the settings it has.
"""

import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile

from setuptools import Distribution, setup
from setuptools.command.build_py import build_py

ROOT = pathlib.Path(__file__).parent
VERSION = re.search(r"project\(rectilin VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text()).group(1)


class BuildWithCMake(build_py):
    def run(self):
        build = pathlib.Path(os.environ.get("RECTILIN_BUILD_DIR", self.build_lib + "-cmake")).absolute()
        options = {
            "CMAKE_BUILD_TYPE": "Release",
            "RECTILIN_APP": "OFF",
            "RECTILIN_TESTS": "OFF",
            "RECTILIN_EXAMPLES": "OFF",
            "RECTILIN_PYTHON": "ON",
            "Python_EXECUTABLE": sys.executable,
        }
        arguments = [f"-D{key}={value}" for key, value in options.items()]
        arguments += shlex.split(os.environ.get("RECTILIN_CMAKE_ARGS", ""))
        if not (build / "CMakeCache.txt").is_file():
            subprocess.run(["cmake", "-S", ROOT, "-B", build, "-G", "Ninja", *arguments], check=True)
        subprocess.run(["cmake", "--build", build, "--target", "rectilin_python"], check=True)
        with tempfile.TemporaryDirectory() as prefix:
            subprocess.run(["cmake", "--install", build, "--component", "python", "--prefix", prefix], check=True)
            package = next(pathlib.Path(prefix).rglob("rectilin/__init__.py")).parent  # wherever below the prefix
            shutil.copytree(package, pathlib.Path(self.build_lib, "rectilin"), dirs_exist_ok=True)


class Binary(Distribution):
    def has_ext_modules(self):  # the wheel is for this machine's kind
        return True

    def has_pure_modules(self):  # or nothing would be built, as no package is listed
        return True


setup(
    name="rectilin",
    version=VERSION,
    description="How rectilinear is a 3D mesh? A certified answer, and a laboratory for optimizers",
    license="MIT",
    python_requires=">=3.8",
    install_requires=["numpy"],
    packages=[],
    cmdclass={"build_py": BuildWithCMake},
    distclass=Binary,
)
