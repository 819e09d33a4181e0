# SPDX-License-Identifier: MIT
"""Every example of the docstrings and of the page runs, and every public name is told of."""
import doctest
import importlib
import inspect
import pathlib
import pkgutil
import re

import pytest

import polydec

ROOT = pathlib.Path(__file__).resolve().parents[2]


@pytest.mark.parametrize("page", ["docs/python.md"])
def test_blocks_of_the_page(page, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path) # for the files that it writes
    found = doctest.testfile(str(ROOT / page), module_relative=False)
    assert found.attempted > 30 and found.failed == 0


def test_a_wrong_block_is_told():
    wrong = doctest.DocTestParser().get_doctest(">>> 1 + 1\n3\n", {}, "wrong", None, 0)
    assert doctest.DocTestRunner(verbose=False).run(wrong, out=lambda text: None).failed == 1


def test_blocks_of_the_readme_run(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path) # for the page that one writes
    blocks = [part.split("```")[0] for part in
              (ROOT / "README.md").read_text().split("```python\n")[1:]]
    assert blocks
    for block in blocks:
        names = {}
        exec(block, names)
        assert names["modes"].certificate.complete


MODULES = ["polydec", *(f"polydec.{each.name}" for each in pkgutil.iter_modules(polydec.__path__)
                        if each.name != "_core")]


@pytest.mark.parametrize("name", MODULES)
def test_examples_of_docstrings(name, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert doctest.testmod(importlib.import_module(name)).failed == 0


def public():
    """Functions, classes and what these have, by name, with the class that it belongs to."""
    for module in (polydec, polydec.meshes):
        for name in module.__all__:
            value = getattr(module, name)
            if inspect.isclass(value) or inspect.isfunction(value):
                yield name, value, None
            if inspect.isclass(value):
                for member, each in vars(value).items():
                    if not member.startswith("_") and (callable(each) or isinstance(
                            each, (property, classmethod, staticmethod))):
                        yield f"{name}.{member}", getattr(each, "__func__", each), value


def silent(name, value, owner):
    """What is not told of it; nothing, if all is."""
    text = inspect.getdoc(value) or ""
    if not text:
        # attributes may be listed by their class
        listed = re.split(r"Attributes\n-+\n", inspect.getdoc(owner) or "")[1:]
        return [] if listed and name.split(".")[1] in listed[0] else [name]
    if not inspect.isfunction(value):
        return []
    about = text + (inspect.getdoc(owner) or "" if owner else "")
    for other in re.findall(r"`([A-Za-z_]+)`", text): # which explains what they share
        named = getattr(polydec, other, None) or getattr(polydec.meshes, other, None)
        about += inspect.getdoc(named) or "" if named else ""
        about += "".join(inspect.getdoc(each) or "" for each in vars(named).values()
                         if inspect.isfunction(each)) if inspect.isclass(named) else ""
    names = [each for each in inspect.signature(value).parameters if each not in ("self", "cls", "complex")]
    return [f"{name}({each})" for each in names if len(names) > 3
            and not re.search(rf"\b{each}\b", about)]


def test_every_public_name_is_told_of():
    assert sum((silent(*each) for each in public()), []) == []
    assert len(list(public())) > 200


def test_what_is_not_told_of_is_found():
    def mute(): ...

    def partly(a, b, c, d):
        """Of a, b and c."""

    assert silent("Mesh.mute", mute, polydec.Mesh) == ["Mesh.mute"]
    assert silent("partly", partly, None) == ["partly(d)"]
    assert silent("Mesh.points", None, polydec.Mesh) == []


def test_public_functions_have_examples():
    functions = [(name, value) for name, value, owner in public()
                 if owner is None and inspect.isfunction(value)]
    without = [name for name, value in functions if ">>>" not in inspect.getdoc(value)]
    assert without == ["to_pyvista"] # which is not here to run it
