# SPDX-License-Identifier: MIT
"""The meshes that the laws are swept over, what errors say, and how long a test may take."""
import faulthandler
import os
import re
import signal

import numpy as np
import pytest

import polydec
from polydec import meshes

MAKERS = {
    "segments": lambda: meshes.kuhn([5]),
    "grid": lambda: meshes.grid(4, 3, 2.0, 1.0),
    "hexagons": lambda: meshes.hexagons(4),
    "well_centered": lambda: meshes.well_centered(4),
    "goldberg": lambda: meshes.goldberg(3),
    "torus": lambda: meshes.torus(8, 6),
    "flange": lambda: meshes.flange(12),
    "moebius": lambda: meshes.moebius(9, 3),
    "kuhn": lambda: meshes.kuhn([2, 2, 2]),
    "bcc": lambda: meshes.bcc(2),
    "fcc": lambda: meshes.fcc(1),
    "clusters": lambda: meshes.sphere_clusters(cells_per_side=4, points_on_sphere=12),
    "tesseract": lambda: meshes.kuhn([1, 1, 1, 1]),
}
_made = {}


def complex_of(name):
    """The merged complex of a mesh, made once."""
    if name not in _made:
        _made[name] = polydec.discretize(MAKERS[name]())
    return _made[name]


def degrees(names=MAKERS, more=0):
    """Pairs of a name and a degree 0..n."""
    dims = {"segments": 1, "kuhn": 3, "bcc": 3, "fcc": 3, "clusters": 3, "tesseract": 4}
    return [(name, k) for name in names for k in range(dims.get(name, 2) + 1 + more)]


def inverted(star):
    """The inverse of a diagonal star, and whether there is one."""
    with np.errstate(divide="ignore"):
        return 1 / star


def near(a, b, tolerance=1e-12):
    """Whether two matrices or arrays agree, relative to their size."""
    difference = a - b
    size = max(abs(a).max() if a.size else 0, abs(b).max() if b.size else 0, 1e-300)
    return (abs(difference).max() if difference.size else 0) <= tolerance * size


def said(*words):
    """The pattern of messages that have all the words or numbers, as a whole and in this order:
    place, kind and what is wrong, by which a message is known however its sentence is put."""
    return "(?s)" + ".*?".join(
        (r"(?<![\w.-])" if word[:1].isdigit() else r"(?<!\w)" if word[:1].isalpha() else "")
        + re.escape(word)
        + (r"(?!\w|\.\d)" if word[-1:].isdigit() else r"(?!\w)" if word[-1:].isalpha() else "")
        for word in map(str, words))


def pytest_configure(config):
    config.real_stderr = os.dup(2) # where no test catches what is written
    # in the background of a script SIGINT is ignored, and Ctrl-C could not be tested
    signal.signal(signal.SIGINT, signal.default_int_handler)


@pytest.fixture(autouse=True)
def watchdog(request):
    """Ends all where a test hangs, and tells where every thread is."""
    seconds = 300 * float(os.environ.get("POLYDEC_TEST_PATIENCE", 1))
    faulthandler.dump_traceback_later(seconds, exit=True, file=request.config.real_stderr)
    yield
    faulthandler.cancel_dump_traceback_later()


@pytest.fixture
def square():
    return complex_of("well_centered")


@pytest.fixture
def sphere():
    return complex_of("goldberg")
