# SPDX-License-Identifier: MIT
"""Discrete exterior calculus on the mesh you have.

    >>> import polydec
    >>> sphere = polydec.discretize(polydec.meshes.goldberg(4))
    >>> sphere.shape                      # vertices, edges, pentagons and hexagons
    (320, 480, 162)
    >>> modes = polydec.spectrum(sphere, side="dual", count=4)
    >>> bool((abs(modes.eigenvalues - [0, 2, 2, 2]) < 0.02).all())
    True

Matrices are ``scipy.sparse.csr_matrix``, and forms are arrays or `Cochain` objects. The exceptions
of this module also derive from Python's built-in ones. Start with `discretize` and `Complex`.
"""
import os as _os

# OpenMP asks when it is loaded how threads wait; spinning would take the time of other programs.
_is_asked = "OMP_WAIT_POLICY" not in _os.environ
if _is_asked:
    _os.environ["OMP_WAIT_POLICY"] = "passive"
from . import _core, meshes
if _is_asked:
    del _os.environ["OMP_WAIT_POLICY"]
from ._core import __version__
from ._cells import Cells
from ._cochain import Cochain
from ._complex import CellList, Complex, Polygons, discretize
from ._boundary_data import outward_flow
from ._distance import (GeodesicDistance, ParallelTransport, ShortestPath, SurfacePaths,
                        geodesic_distance)
from ._engines import (Backend, Solution, backends, load_engine, register_eigen_solver,
                       register_linear_solver, set_memory_limit, solve)
from ._errors import (BackendUnavailable, Error, InvalidInput, IoError, PolydecWarning,
                      SolverFailure)
from ._evolution import Evolution, heat
from ._fields import (LieDerivative, boundary_de_rham, de_rham, flat, flux_form, flux_sharp,
                      gradient, inflow, interior_product, lie_derivative, primal_dual_wedge,
                      sharp_pd, sharp_pp, wedge, whitney_at_centroids, whitney_form)
from ._draw import Drawing, draw
from ._flow import (Flow, FluxTransport, IncompressibleFlow, ShallowWater, flow_of_velocity,
                    flow_of_vorticity, flux_through_boundary)
from ._given import as_mesh, split_polygons
from ._hodge import HodgeParts, HodgeSolver, harmonic_forms, hodge_decomposition
from ._merging import Merging
from ._mesh import LengthMesh, Mesh, read_lengths, read_mesh, write_lengths, write_mesh
from ._periodic import PeriodicMesh, glue, periodic
from ._plot import plot, to_meshio, to_pyvista
from ._run import Run
from ._shape import (CountBelow, PoissonError, ShapeSpectrum, count_below, goal_interval,
                     poisson_error, shape_spectrum)
from ._sources import (CurlCurlSolution, PoissonSolution, PoissonSolver, StokesFlow, StokesSolver,
                       poisson)
from ._space import FormSpace
from ._spectra import Certificate, Eigenpairs, Spectrum, smallest_eigenpairs, spectrum
from ._view import Page, Series, view, write_vtu
from ._waves import AbsorbingLayer, Waves, stable_step, wave

__all__ = [
    "__version__", "meshes", "AbsorbingLayer", "Backend", "BackendUnavailable", "CellList",
    "Cells", "Certificate", "Cochain", "Complex", "CountBelow", "CurlCurlSolution", "Drawing",
    "Eigenpairs", "Error", "Evolution", "Flow", "FluxTransport", "FormSpace",
    "GeodesicDistance", "HodgeParts", "HodgeSolver", "IncompressibleFlow", "InvalidInput",
    "IoError", "LengthMesh", "LieDerivative", "Merging", "Mesh", "Page", "ParallelTransport",
    "PeriodicMesh", "PoissonError", "PoissonSolution", "PoissonSolver", "PolydecWarning",
    "Polygons", "Run", "Series", "ShallowWater", "ShapeSpectrum", "ShortestPath",
    "SurfacePaths", "Solution", "SolverFailure", "Spectrum", "StokesFlow", "StokesSolver",
    "Waves", "as_mesh", "backends", "boundary_de_rham", "count_below", "de_rham", "discretize",
    "draw", "flat", "flow_of_velocity", "flow_of_vorticity", "flux_form", "flux_sharp",
    "flux_through_boundary", "geodesic_distance", "glue", "goal_interval", "gradient",
    "harmonic_forms", "heat", "hodge_decomposition", "inflow", "interior_product",
    "lie_derivative", "load_engine", "outward_flow", "periodic", "plot", "poisson",
    "poisson_error", "primal_dual_wedge", "read_lengths", "read_mesh", "register_eigen_solver",
    "register_linear_solver", "set_memory_limit", "shape_spectrum", "sharp_pd", "sharp_pp",
    "smallest_eigenpairs", "solve", "spectrum", "split_polygons", "stable_step", "to_meshio",
    "to_pyvista", "view", "wave", "wedge", "whitney_at_centroids", "whitney_form",
    "write_lengths", "write_mesh", "write_vtu",
]

# a forked child inherits the memory of the parent's threads, but not the running threads
if hasattr(_os, "register_at_fork"):
    _os.register_at_fork(after_in_child=_core.use_one_thread)
