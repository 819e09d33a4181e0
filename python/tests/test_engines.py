# SPDX-License-Identifier: MIT
"""Engines that there are, that there are not, and one's own."""
import os

import numpy as np
import pytest
import scipy.sparse as sp
import scipy.sparse.linalg

import polydec
from conftest import python, refused

SYMMETRIC = sp.diags([[-1.0] * 49, [2.5] * 50, [-1.0] * 49], [-1, 0, 1])


def direct(A):
    return scipy.sparse.linalg.splu(A.tocsc()).solve


polydec.register_linear_solver("python.superlu", direct)


@pytest.mark.parametrize("name", [engine.name for engine in polydec.backends()
                                  if engine.kind == "linear" and engine.available])
def test_every_engine_solves(name):
    exact = np.sin(np.arange(50))
    solution = polydec.solve(SYMMETRIC, SYMMETRIC @ exact, engine=name, positive=True)
    assert np.allclose(solution, exact, atol=1e-9)
    assert solution.report["residual"] < 1e-9


def test_engines_of_modules_are_found():
    folder = os.path.join(os.path.dirname(polydec.__file__), "engines")
    names = {engine.name for engine in polydec.backends() if engine.available}
    for module in os.listdir(folder) if os.path.isdir(folder) else []:
        name = module.partition(".")[0]
        assert any(known.partition(".")[0] == name for known in names)
        polydec.load_engine(name)
        polydec.load_engine(os.path.join(folder, module))


def test_engines_that_there_are_not(tmp_path):
    refused(lambda: polydec.load_engine("nonsense"), "eigen.ldlt")
    refused(lambda: polydec.solve(SYMMETRIC, np.ones(50), engine="nonsense"), "eigen.ldlt")
    refused(lambda: polydec.load_engine(tmp_path / "nothing.so"), error=polydec.IoError)
    missing = [engine for engine in polydec.backends()
               if not engine.available and engine.kind == "linear"]
    for engine in missing:
        assert engine.how_to_get
        refused(lambda: polydec.solve(SYMMETRIC, np.ones(50), engine=engine.name),
                error=polydec.BackendUnavailable)


def test_without_modules():
    code = ("import polydec; c = polydec.discretize(polydec.meshes.grid(4, 4))\n"
            "print(polydec.poisson(c, 1.0).report['engine'])\n"
            "try: polydec.load_engine('cholmod')\n"
            "except polydec.BackendUnavailable as error: print(isinstance(error, ImportError))")
    assert python("-c", code, POLYDEC_ENGINES="").stdout == "eigen.ldlt\nTrue\n"


def test_auto_says_once_which_engine_it_missed():
    code = ("import numpy as np, polydec, scipy.sparse as sp\n"
            "for _ in range(3): polydec.solve(sp.eye(60000), np.ones(60000), positive=True)")
    told = python("-c", code, POLYDEC_ENGINES="").stderr
    assert told.count("PolydecWarning") == 1
    assert "cholmod" in told and "libsuitesparse-dev" in told


def test_licenses_of_engines():
    licenses = {engine.name: engine.license for engine in polydec.backends()
                if not engine.name.startswith("python.")}
    assert "GPL" in licenses["cholmod"] and licenses["eigen.ldlt"] == "MPL-2.0"


def test_own_engine_everywhere(square):
    u = polydec.poisson(square, 1.0, engine="python.superlu")
    assert u.report["engine"] == "python.superlu"
    assert np.allclose(u, polydec.poisson(square, 1.0))
    assert np.allclose(polydec.heat(square, u, 0.1, engine="python.superlu"),
                       polydec.heat(square, u, 0.1))
    own = polydec.spectrum(square, count=4, linear_solver="python.superlu", certified=False)
    assert np.allclose(own.eigenvalues, polydec.spectrum(square, count=4).eigenvalues, atol=1e-8)


def test_own_engines_are_checked():
    polydec.register_linear_solver("python.wrong", lambda A: lambda B: 0.9 * direct(A)(B))
    polydec.register_linear_solver("python.short", lambda A: lambda B: B[:-1])
    polydec.register_linear_solver("python.raises", lambda A: 1 / 0)
    error = refused(lambda: polydec.solve(SYMMETRIC, np.ones(50), engine="python.wrong"),
                     error=polydec.SolverFailure)
    assert error.report["engine"] == "python.wrong"
    assert error.report["residual"] > 1e-6 and isinstance(error, ArithmeticError)
    refused(lambda: polydec.solve(SYMMETRIC, np.ones(50), engine="python.short"),
            error=polydec.SolverFailure)
    with pytest.raises(ZeroDivisionError):
        polydec.solve(SYMMETRIC, np.ones(50), engine="python.raises")
    refused(lambda: polydec.register_linear_solver("python.wrong", direct),
            "python.wrong") # the name is taken


def test_own_eigensolver(square):
    calls = []

    def largest(A, count, dimension, tolerance, start):
        calls.append(A.shape)
        return scipy.sparse.linalg.eigsh(A, count, ncv=dimension, tol=tolerance, v0=start)

    polydec.register_eigen_solver("python.arpack", largest)
    modes = polydec.spectrum(square, count=4, eigen_solver="python.arpack")
    assert calls and modes.eigen_solver == "python.arpack" and modes.certificate.complete
    assert np.allclose(modes.eigenvalues, polydec.spectrum(square, count=4).eigenvalues, atol=1e-8)
    polydec.register_eigen_solver("python.broken", lambda *arguments: 1 / 0)
    with pytest.raises(ZeroDivisionError):
        polydec.spectrum(square, count=4, eigen_solver="python.broken")


def test_operators_of_own_eigensolvers_end_with_the_call(square):
    kept = []

    def largest(A, count, dimension, tolerance, start):
        kept.append(A)
        values, vectors = np.linalg.eigh(A @ np.eye(A.shape[0]))
        return values[-count:], vectors[:, -count:]

    polydec.register_eigen_solver("python.keeps", largest)
    polydec.spectrum(square, count=4, eigen_solver="python.keeps")
    for A in kept:
        refused(lambda: A @ np.ones(A.shape[1]), "operator", "after its call")


def test_memory_limit():
    code = ("import polydec; polydec.set_memory_limit(10 ** 6)\n"
            "try: polydec.discretize(polydec.meshes.grid(300, 300))\n"
            "except polydec.IoError as error: print('memory' in str(error))")
    assert python("-c", code).stdout == "True\n"
