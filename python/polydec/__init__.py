# SPDX-License-Identifier: MIT
"""Discrete exterior calculus on the mesh you have.

    >>> import polydec
    >>> sphere = polydec.discretize(polydec.meshes.goldberg(4))
    >>> sphere.shape                      # vertices, edges, pentagons and hexagons
    (320, 480, 162)
    >>> modes = polydec.spectrum(sphere, side="dual", count=4)
    >>> (abs(modes.eigenvalues - [0, 2, 2, 2]) < 0.02).all()
    True

Matrices are ``scipy.sparse.csr_matrix``, forms are arrays or `Cochain` objects, and errors are
those of this module, which are Python's own too. See `discretize` and `Complex` first.
"""
from . import meshes
from ._cells import Cells, ConditionedCells
from ._cochain import Cochain
from ._complex import CellList, Complex, Merging, Polygons, discretize
from ._engines import (Backend, Solution, backends, load_engine, register_eigen_solver,
                       register_linear_solver, solve)
from ._errors import BackendUnavailable, Error, InvalidInput, IoError, SolverFailure
from ._solvers import PoissonSolver, poisson
from ._spectra import Certificate, Eigenpairs, Spectrum, smallest_eigenpairs, spectrum
from .meshes import LengthMesh, Mesh, read_lengths, read_mesh, write_lengths, write_mesh
