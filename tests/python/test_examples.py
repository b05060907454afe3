"""The examples and every docstring run as they are written."""

import doctest
import inspect
import os
import pathlib
import subprocess
import sys

import pytest

import rectilin

ROOT = pathlib.Path(__file__).parents[2]
EXAMPLES = sorted((ROOT / "python" / "examples").glob("*.py"))


@pytest.mark.parametrize("example", EXAMPLES, ids=lambda path: path.stem)
def test_example(example, tmp_path):
    done = subprocess.run([sys.executable, str(example)], cwd=tmp_path, capture_output=True, text=True, timeout=600)
    assert done.returncode == 0, done.stderr
    assert done.stdout
    for file in tmp_path.iterdir():
        beside = file.name.endswith((".db-journal", ".db-lock"))  # of SQLite, empty when nothing is being written
        assert beside or file.is_dir() or file.stat().st_size > 0


def test_readme(tmp_path):
    """The README's program runs as it is written."""
    rectilin.save(tmp_path / "chair.off", "shape:stairs?rotate=random")
    program = (ROOT / "README.md").read_text().split("```python\n")[1].split("```")[0]
    done = subprocess.run([sys.executable, "-c", program], cwd=tmp_path, capture_output=True, text=True, timeout=600)
    assert done.returncode == 0, done.stderr
    assert done.stdout.startswith("R is between ")
    assert (tmp_path / "page" / "index.html").is_file() and (tmp_path / "posed.ply").is_file()


def documented():
    yield "rectilin", rectilin
    for name in rectilin.__all__:
        thing = getattr(rectilin, name)
        yield name, thing
        if inspect.isclass(thing):
            for member, value in vars(thing).items():
                if not member.startswith("_"):
                    yield f"{name}.{member}", value


def test_every_name_is_documented_and_most_by_example():
    examples = 0
    for name, thing in documented():
        if name in ("__version__", "rectilin"):
            continue
        text = inspect.getdoc(thing) or ""
        if "." not in name:
            assert len(text) > 30, name
            if not isinstance(thing, type):
                assert ">>>" in text, name
                examples += 1
    assert examples >= 12


def test_docstrings(doctest_namespace, tmp_path):
    finder, count, failures = doctest.DocTestFinder(recurse=False), 0, []
    for name, thing in documented():
        for test in finder.find(thing, name, module=False, globs={**doctest_namespace, "folder": str(tmp_path / name)}):
            doctest.DocTestRunner(optionflags=doctest.ELLIPSIS).run(test, out=failures.append)
            count += len(test.examples)
    assert not failures, "".join(failures)
    assert count > 40


def test_stubs_name_what_there_is():
    stubs = (pathlib.Path(rectilin.__file__).parent / "__init__.pyi").read_text()
    scope = {}
    exec(compile(stubs.replace("...", "None"), "stubs", "exec"), scope)
    assert set(rectilin.__all__) <= set(scope) | set(scope["__annotations__"])
    for name in rectilin.__all__:
        thing = getattr(rectilin, name)
        if not inspect.isclass(thing) or issubclass(thing, BaseException):
            continue
        stub = vars(scope[name])
        stubbed = {m for m in stub if not m.startswith("_")} | set(stub.get("__annotations__", ()))
        there = {m for m in vars(thing) if not m.startswith("_")}
        assert there == stubbed, name
