# SPDX-License-Identifier: MIT
"""Builds the module of the package for Python by CMake, for pip install . and its like.

The wheel is for the Python that runs this. Without further words it holds no part under the GPL: the
engines of CHOLMOD, PETSc and SLEPc are left out, since SuiteSparse, and PETSc as Debian builds it,
bring such parts. In the environment CMAKE_ARGS holds more options for CMake, such as
-DPOLYDEC_CHOLMOD=ON; POLYDEC_BUILD names a build tree to take as it is, such as build/release;
POLYDEC_JOBS is how many compilers run at once (default: processors, at most 2).
"""
import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = Path(__file__).resolve().parent
OPTIONS = ["-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_CXX_FLAGS_RELEASE=-O2 -DNDEBUG",
           "-DBUILD_SHARED_LIBS=OFF", "-DPOLYDEC_COMPILE_BY_MODULE=ON", "-DPOLYDEC_PYTHON=ON",
           *(f"-DPOLYDEC_{part}=OFF" for part in
             ("COMMAND", "EXAMPLES", "BENCHMARKS", "DISTRIBUTED", "CHOLMOD", "PETSC", "SLEPC"))]


class CMakeBuild(build_ext):
    """Installs what CMake builds beside the package's files."""

    def build_extension(self, ext):
        package = Path(self.get_ext_fullpath(ext.name)).resolve().parent
        given = os.environ.get("POLYDEC_BUILD")
        binary = Path(given or self.build_temp).resolve()
        jobs = os.environ.get("POLYDEC_JOBS") or str(min(2, os.cpu_count() or 1))
        if not given:
            self.cmake("-S", ROOT, "-B", binary, *(["-G", "Ninja"] if shutil.which("ninja") else []),
                       *OPTIONS, f"-DPython_EXECUTABLE={sys.executable}", *pybind11_options(),
                       *shlex.split(os.environ.get("CMAKE_ARGS", "")))
        self.cmake("--build", binary, "-j", jobs, "--target", "polydec_python", "polydec_modules")
        with tempfile.TemporaryDirectory() as prefix:
            for component in ("python", "python_engines"):
                self.cmake("--install", binary, "--prefix", prefix, "--component", component)
            installed = next(Path(prefix).rglob("_core.*.so")).parent
            shutil.copytree(installed, package, dirs_exist_ok=True)

    @staticmethod
    def cmake(*words):
        subprocess.run(["cmake", *map(str, words)], cwd=ROOT, check=True)


def pybind11_options():
    """Where this Python's own pybind11 is, if it has one; else CMake looks for the system's."""
    try:
        import pybind11
        return [f"-Dpybind11_DIR={pybind11.get_cmake_dir()}"]
    except ImportError:
        return []


VERSION = re.search(r"project\(polydec VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text())
setup(version=VERSION.group(1), ext_modules=[Extension("polydec._core", sources=[])],
      cmdclass={"build_ext": CMakeBuild})
