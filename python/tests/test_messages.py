# SPDX-License-Identifier: MIT
"""Messages name what there is in Python, and say what positions are needed for."""
import numpy as np
import pytest
import scipy.sparse as sp

import polydec
from conftest import refused


def test_words_of_messages():
    c = polydec.discretize(polydec.meshes.perturbed(polydec.meshes.grid(9, 9), 0.1, 2),
                           star="circumcentric")
    advice = c.report()["advice"]
    assert advice and not any("::" in text for text in advice)
    with pytest.raises(polydec.InvalidInput) as caught:
        polydec.spectrum(polydec.discretize(polydec.meshes.perturbed(polydec.meshes.fcc(1), 0.05),
                                            star="circumcentric"), degree=1)
    assert "::" not in str(caught.value) and caught.value.cells


SQUARE = polydec.discretize(polydec.meshes.grid(4, 4), merge=False, star="circumcentric")
LENGTHS = polydec.discretize(polydec.meshes.length_mesh(polydec.meshes.grid(4, 4)))
SINGULAR = sp.csr_matrix([[1.0, -1], [-1, 1]])


@pytest.mark.parametrize("ask, words", [
    (lambda: polydec.SurfacePaths(LENGTHS, 0), ("lengths", "use geodesic_distance")),
    (lambda: SQUARE.cochain(np.ones(25), 0).wedge(SQUARE.cochain(np.ones(32), 0, "dual")),
     ("use wedge", 'wedge(.., side="dual")', "primal_dual_wedge")),
    (lambda: polydec.flat(SQUARE, "dpp", np.ones((32, 2))), ("dpp", "zeros(1)")),
    (lambda: polydec.solve(SINGULAR, [1.0, 0]), ("singular", "expected", "inverse")),
    (lambda: polydec.solve(SINGULAR, [1.0, 0], engine="eigen.ldlt"), ("matrix with an inverse",)),
    (lambda: polydec.solve(SINGULAR, [1.0, 0], engine="eigen.cg"), ("not known",)),
    (lambda: polydec.solve(sp.csr_matrix([[1.0, 2], [3, 4]]), [1.0, 0], engine="eigen.ldlt"),
     ("symmetric=True",))])
def test_messages_name_what_there_is_in_python(ask, words):
    error = refused(ask, *words, error=polydec.Error)
    for name in ("::", "facts", "ShortestPaths", " dual_wedge"):
        assert name not in str(error)


@pytest.mark.parametrize("name, ask", [
    ("f", lambda at: polydec.poisson(LENGTHS, at)),
    ("boundary values", lambda at: polydec.poisson(LENGTHS, 1.0, at)),
    ("essential", lambda at: polydec.poisson(LENGTHS, 1.0, essential=at)),
    ("Robin", lambda at: polydec.spectrum(LENGTHS, robin=at)),
    ("fixed", lambda at: polydec.poisson(LENGTHS, 1.0, fixed=at)),
    ("f", lambda at: polydec.poisson(LENGTHS.input, at))])
def test_functions_of_positions_need_positions(name, ask):
    refused(lambda: ask(lambda x: x[:, 0]), "lengths", name, "points")
