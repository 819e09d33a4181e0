# SPDX-License-Identifier: MIT
"""Numbers of an independent program through Python: those of POLYDEC_TEST_DATA. Cells, stars and volumes
are compared by the command, whose files hold what the package has (tests/tools/operator_files.py)."""
import functools
import json
import os
import pathlib

import numpy as np
import pytest

import polydec

DATA = pathlib.Path(os.environ.get("POLYDEC_TEST_DATA", "."))


def golden(name):
    path = DATA / "golden" / name
    return json.loads(path.read_text()) if path.is_file() else {}


EXPECTED = golden("expected.json")
CALCULUS = golden("expected_calculus.json")
pytestmark = pytest.mark.skipif(not EXPECTED, reason="POLYDEC_TEST_DATA has no golden/expected.json")


@functools.cache
def complex_of(name):
    folder = DATA if name.startswith("meshes/") else DATA / "golden"
    return polydec.discretize(folder / name, tolerance=1e-8, star="circumcentric")


def near(value, expected, scale=0.0, tolerance=1e-8):
    assert abs(value - expected) <= tolerance * max(abs(expected), scale, 1e-3)


@pytest.mark.parametrize("name, k", [(name, k) for name, each in EXPECTED.items() for k in range(5)
                                     if f"L{k}" in each])
def test_laplacians_and_spectra(name, k):
    c, expected = complex_of(name), EXPECTED[name][f"L{k}"]
    L = c.laplacian(k).toarray()
    near(np.trace(L), expected["trace"], expected["abs_sum"])
    near(np.linalg.norm(L), expected["frobenius"])
    near(abs(L).sum(), expected["abs_sum"])
    wanted = EXPECTED[name].get(f"spectrum{k}")
    if wanted is None or wanted["complex"]:
        return
    values = np.linalg.eigvals(L)
    found = np.sort(values[np.argsort(abs(values))].real[:len(wanted["smallest"])])
    scale = abs(np.array(wanted["smallest"])).max()
    assert np.allclose(found, np.sort(wanted["smallest"]), rtol=1e-7, atol=1e-7 * scale)
    if len(wanted["smallest"]) < len(L) and all((c.star(j) > 0).all() for j in range(c.dim + 1)):
        count = len(wanted["smallest"]) - 1 # the last may have copies that are not listed
        modes = polydec.spectrum(c, degree=k, count=count)
        assert modes.certificate.complete
        assert np.allclose(modes.eigenvalues, sorted(wanted["smallest"])[:count], rtol=1e-7,
                           atol=1e-7 * scale)


def coordinates(x):
    return [x[:, i] if i < x.shape[1] else np.zeros(len(x)) for i in range(4)]


def alpha(p):
    x, y, z, w = coordinates(p)
    return np.column_stack([1 - y + x * z, x ** 2 + y, y * z + x, w + x])[:, :p.shape[1]]


def beta(p):
    x, y, z, w = coordinates(p)
    return np.column_stack([y, z - x, x * y + 1, w ** 2])[:, :p.shape[1]]


@pytest.mark.parametrize("name", CALCULUS)
def test_forms(name):
    c, expected = complex_of(name), CALCULUS[name]
    assert list(c.shape) == expected.get("counts", list(c.shape))
    assert c.betti_numbers() == expected.get("betti", c.betti_numbers())
    forms = {each: c.cochain(polydec.de_rham(c, 1, field), 1)
             for each, field in (("alpha", alpha), ("beta", beta)) if each in expected}
    for each, form in forms.items():
        wanted = expected[each]
        near(np.linalg.norm(form), wanted["norm"])
        near(abs(form.values).sum(), wanted["abs_sum"])
        near(np.linalg.norm(form.d()), wanted["d_norm"], wanted["norm"])
        if "star_square" in wanted:
            near(form.values @ (c.star(1) * form.values), wanted["star_square"], wanted["norm"])
    if "wedge_alpha_beta" in expected and len(forms) == 2:
        wedge, wanted = forms["alpha"].wedge(forms["beta"]).values, expected["wedge_alpha_beta"]
        near(np.linalg.norm(wedge), wanted["norm"])
        near(abs(wedge).sum(), wanted["abs_sum"])
    f = c.cochain(np.sin(1 + np.arange(c.size(0))), 0)
    if "wedge_f_alpha" in expected:
        near(np.linalg.norm(f.wedge(forms["alpha"])), expected["wedge_f_alpha"]["norm"])


@pytest.mark.parametrize("name", [name for name, each in CALCULUS.items()
                                  if "hodge1_absolute" in each])
def test_hodge_decompositions(name):
    c, wanted = complex_of(name), CALCULUS[name]["hodge1_absolute"]
    form = c.cochain(polydec.de_rham(c, 1, alpha), 1)
    found = polydec.hodge_decomposition(c, form)
    for part in ("exact", "coexact", "harmonic"):
        near(getattr(found, part).norm() ** 2, wanted[part], wanted["total"], 1e-7)
