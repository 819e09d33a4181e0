# SPDX-License-Identifier: MIT
"""The flaws that mutate.py plants: name, file, text that occurs once in it, replacement, and
a test that fails with it: mutate.py runs it first, and all tests if it passes or none is named."""
from . import backends, dec, distributed, io, meshes, shape, solvers

MUTANTS = {name: flaw for folder in (backends, dec, distributed, io, meshes, shape, solvers)
           for name, flaw in folder.MUTANTS.items()}
