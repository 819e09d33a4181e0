# SPDX-License-Identifier: MIT
"""Installs the package by pip from a copy of the checkout, without a network, and uses it from
another folder.

Usage: install.py PYTHON VERSION BUILD [ENGINE ..]. With ccache all is compiled anew, else what is in
the build tree BUILD is taken. Exit code: 0 all went well, 1 not, 77 what pip needs is not here.
"""
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
NEEDED = {"venv": "python3-venv", "pip": "python3-pip", "setuptools": "python3-setuptools",
          "wheel": "python3-wheel"}
# What is not optimized compiles in a third of the time.
QUICK = ["-DCMAKE_CXX_FLAGS_RELEASE=-O0", "-DPOLYDEC_PETSC=OFF", "-DPOLYDEC_SLEPC=OFF",
         "-DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON"]
USE = """
import pathlib, sys, polydec
assert pathlib.Path(polydec.__file__).is_relative_to(sys.prefix), polydec.__file__
assert polydec.__version__ == sys.argv[1], polydec.__version__
sphere = polydec.discretize(polydec.meshes.goldberg(3))
modes = polydec.spectrum(sphere, count=4)
assert modes.certificate.complete and abs(modes.eigenvalues[1] - 2) < 0.02
folder = pathlib.Path(polydec.__file__).parent / "engines"
modules = {path.stem for path in folder.glob("*.so")}
found = {engine.name.split(".")[0] for engine in polydec.backends() if engine.available}
assert modules <= found, (modules, found)
assert modules >= {"cholmod", "mumps"} & set(sys.argv[2:]), modules
print("installed:", polydec.__version__, *sorted(modules))
"""


def run(*words, cwd, **variables):
    """Runs with nothing in the environment that could point to a build tree."""
    kept = {name: os.environ[name] for name in ("PATH", "HOME", "CCACHE_DIR", "POLYDEC_JOBS")
            if name in os.environ}
    done = subprocess.run([str(word) for word in words], cwd=cwd, text=True,
                          env={**kept, "LC_ALL": "C", **variables},
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    if done.returncode != 0:
        sys.exit(f"exit code {done.returncode} of {' '.join(map(str, words))}\n{done.stdout}")
    return done.stdout


def main(python, version, build, *engines):
    missing = [package for module, package in NEEDED.items() if subprocess.run(
        [python, "-c", f"import {module}"], capture_output=True).returncode != 0]
    if missing:
        print("skipped: install", *missing)
        return 77
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        copy = folder / "checkout"
        shutil.copytree(ROOT, copy, ignore=shutil.ignore_patterns(
            "build", ".git", ".cache", "demo-output", "__pycache__"))
        run(python, "-m", "venv", "--system-site-packages", folder / "venv", cwd=folder)
        own = folder / "venv" / "bin" / "python"
        how = {"CMAKE_CXX_COMPILER_LAUNCHER": "ccache", "CCACHE_BASEDIR": str(copy),
               "CCACHE_NOHASHDIR": "1", "CMAKE_ARGS": " ".join(QUICK)}
        if not shutil.which("ccache"):
            how = {"POLYDEC_BUILD": build}
        run(own, "-m", "pip", "--isolated", "install", "--no-cache-dir", "--no-index",
            "--no-build-isolation", ".", cwd=copy, **how)
        shutil.rmtree(copy)
        print(run(own, "-c", USE, version, *engines, cwd=folder), end="")
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
