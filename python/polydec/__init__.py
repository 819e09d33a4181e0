# SPDX-License-Identifier: MIT
"""Discrete exterior calculus on the mesh you have.

    >>> import polydec
    >>> sphere = polydec.discretize(polydec.meshes.goldberg(4))
    >>> sphere.shape                      # vertices, edges, pentagons and hexagons
    (320, 480, 162)
    >>> modes = polydec.spectrum(sphere, side="dual", count=4)
    >>> bool((abs(modes.eigenvalues - [0, 2, 2, 2]) < 0.02).all())
    True

Matrices are ``scipy.sparse.csr_matrix``, forms are arrays or `Cochain` objects, and errors are
those of this module, which are Python's own too. See `discretize` and `Complex` first.
"""
from . import meshes
from ._core import __version__
from ._cells import Cells, ConditionedCells
from ._cochain import Cochain
from ._complex import CellList, Complex, Merging, Polygons, discretize
from ._distance import GeodesicDistance, ParallelTransport, geodesic_distance
from ._engines import (Backend, Solution, backends, load_engine, register_eigen_solver,
                       register_linear_solver, set_memory_limit, solve)
from ._errors import BackendUnavailable, Error, InvalidInput, IoError, SolverFailure
from ._evolution import HeatSolver, Leapfrog, heat, stable_step, wave
from ._fields import (de_rham, flat, flux_form, flux_sharp, gradient, inflow, interior_product,
                      lie_derivative, primal_dual_wedge, sharp_pd, sharp_pp, wedge,
                      whitney_at_centroids, whitney_form)
from ._given import as_mesh, split_polygons
from ._mesh import LengthMesh, Mesh, read_lengths, read_mesh, write_lengths, write_mesh
from ._plot import plot, to_meshio, to_pyvista
from ._solvers import (DarcyFlow, DarcySolver, HodgeParts, HodgeSolver, PoissonSolver, darcy,
                       harmonic_forms, hodge_decomposition, poisson)
from ._spectra import Certificate, Eigenpairs, Spectrum, smallest_eigenpairs, spectrum
from ._view import Page, view, write_vtu

__all__ = [
    "__version__", "meshes", "Backend", "BackendUnavailable", "CellList", "Cells", "Certificate", "Cochain",
    "Complex", "ConditionedCells", "DarcyFlow", "DarcySolver", "Eigenpairs", "Error",
    "GeodesicDistance", "HeatSolver", "HodgeParts", "HodgeSolver", "InvalidInput", "IoError",
    "Leapfrog", "LengthMesh", "Merging", "Mesh", "Page", "ParallelTransport", "PoissonSolver",
    "Polygons", "Solution", "SolverFailure", "Spectrum", "as_mesh", "backends", "darcy",
    "de_rham", "discretize", "flat", "flux_form", "flux_sharp", "geodesic_distance", "gradient",
    "harmonic_forms", "heat", "hodge_decomposition", "inflow", "interior_product",
    "lie_derivative", "load_engine", "plot", "poisson", "primal_dual_wedge", "read_lengths",
    "read_mesh", "register_eigen_solver", "register_linear_solver", "set_memory_limit",
    "sharp_pd", "sharp_pp", "smallest_eigenpairs", "solve", "spectrum", "split_polygons",
    "stable_step", "to_meshio", "to_pyvista", "view", "wave", "wedge", "whitney_at_centroids",
    "whitney_form", "write_lengths", "write_mesh", "write_vtu",
]
