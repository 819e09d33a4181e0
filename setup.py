# SPDX-License-Identifier: MIT
"""Builds the module of the package for Python by CMake, for pip install . and its like.

In the environment CMAKE_ARGS may hold more options for CMake, such as -DPOLYDEC_CHOLMOD=OFF, and
POLYDEC_JOBS how many compilers run at once (default: processors, at most 2).
"""
import os
import re
import shlex
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = Path(__file__).resolve().parent


class CMakeBuild(build_ext):
    """Installs what CMake builds beside the package's files."""

    def build_extension(self, ext):
        binary = Path(self.build_temp).resolve()
        site = Path(self.get_ext_fullpath(ext.name)).resolve().parents[1]
        jobs = os.environ.get("POLYDEC_JOBS") or str(min(2, os.cpu_count() or 1))
        self.cmake("--preset", "release", "-B", binary, "-DPOLYDEC_PYTHON=ON",
                   "-DPOLYDEC_COMMAND=OFF", "-DPOLYDEC_TESTS=OFF", "-DPOLYDEC_EXAMPLES=OFF",
                   "-DPOLYDEC_PYTHON_SITE=.", f"-DPython_EXECUTABLE={sys.executable}",
                   *shlex.split(os.environ.get("CMAKE_ARGS", "")))
        self.cmake("--build", binary, "-j", jobs, "--target", "polydec_python", "polydec_modules")
        for component in ("python", "python_engines"):
            self.cmake("--install", binary, "--prefix", site, "--component", component)

    @staticmethod
    def cmake(*words):
        subprocess.run(["cmake", *map(str, words)], cwd=ROOT, check=True)


VERSION = re.search(r"project\(polydec VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text())
setup(version=VERSION.group(1), ext_modules=[Extension("polydec._core", sources=[])],
      cmdclass={"build_ext": CMakeBuild})
