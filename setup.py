# SPDX-License-Identifier: MIT
"""Builds the module of the package for Python by CMake, for pip install . and its like.

In the environment POLYDEC_BUILD may name a build tree to take as it is, such as build/release, or
CMAKE_ARGS hold more options for CMake, such as -DPOLYDEC_CHOLMOD=OFF; POLYDEC_JOBS is how many
compilers run at once (default: processors, at most 2).
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


class CMakeBuild(build_ext):
    """Installs what CMake builds beside the package's files."""

    def build_extension(self, ext):
        package = Path(self.get_ext_fullpath(ext.name)).resolve().parent
        given = os.environ.get("POLYDEC_BUILD")
        binary = Path(given or self.build_temp).resolve()
        jobs = os.environ.get("POLYDEC_JOBS") or str(min(2, os.cpu_count() or 1))
        if not given:
            self.cmake("--preset", "release", "-B", binary, "-DPOLYDEC_PYTHON=ON",
                       "-DBUILD_SHARED_LIBS=OFF", "-DPOLYDEC_WERROR=OFF",
                       "-DPOLYDEC_COMMAND=OFF", "-DPOLYDEC_EXAMPLES=OFF",
                       f"-DPython_EXECUTABLE={sys.executable}",
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


VERSION = re.search(r"project\(polydec VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text())
setup(version=VERSION.group(1), ext_modules=[Extension("polydec._core", sources=[])],
      cmdclass={"build_ext": CMakeBuild})
