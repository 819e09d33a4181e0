# SPDX-License-Identifier: MIT
"""Meshes of the laws, assertions about errors, and the time limit of a test."""
import faulthandler
import functools
import os
import signal
import subprocess
import sys
import threading
from pathlib import Path

import pytest

import polydec
from polydec import meshes

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tests" / "support"))
from words import pattern as said  # noqa: E402

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


@functools.cache
def complex_of(name):
    """The merged complex of a mesh, made once, with circumcentric stars."""
    return polydec.discretize(MAKERS[name](), star="circumcentric")


def degrees(names=MAKERS, more=0):
    """Pairs of a name and a degree 0..n."""
    dims = {"segments": 1, "kuhn": 3, "bcc": 3, "fcc": 3, "clusters": 3, "tesseract": 4}
    return [(name, k) for name in names for k in range(dims.get(name, 2) + 1 + more)]


def near(a, b, tolerance=1e-12):
    """Whether two matrices or arrays agree, relative to their size."""
    difference = a - b
    size = max(abs(a).max() if a.size else 0, abs(b).max() if b.size else 0, 1e-300)
    return (abs(difference).max() if difference.size else 0) <= tolerance * size


def refused(ask, *words, error=polydec.InvalidInput):
    """The error that this raises, whose message has the words."""
    with pytest.raises(error, match=said(*words)) as caught:
        ask()
    return caught.value


def together(*works):
    """Runs these, each in a thread of its own."""
    threads = [threading.Thread(target=work) for work in works]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()


def is_interrupted(work, after=0.2):
    """Whether a Ctrl-C after so many seconds ends the work, which takes far longer."""
    timer = threading.Timer(after, os.kill, (os.getpid(), signal.SIGINT))
    timer.start()
    try:
        work()
    except KeyboardInterrupt:
        return True
    finally:
        timer.cancel()
        timer.join()
    return False


def run(*words, cwd=None, **environment):
    """The end of a program, which must not fail."""
    home = str(Path(polydec.__file__).parents[1])
    done = subprocess.run([*map(str, words)], cwd=cwd, capture_output=True, text=True, timeout=200,
                          env={**os.environ, "PYTHONPATH": home, **environment})
    assert done.returncode == 0, done.stderr
    return done


python = functools.partial(run, sys.executable)


def pytest_configure(config):
    config.real_stderr = os.dup(2) # not captured by pytest
    # scripts start background jobs with SIGINT ignored; the tests of Ctrl-C need it
    signal.signal(signal.SIGINT, signal.default_int_handler)


@pytest.fixture(autouse=True)
def watchdog(request):
    """Ends the run at the time limit of a test, with the stacks of all threads."""
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


@pytest.fixture
def grouped_square(tmp_path):
    """A file of the unit square, two triangles, whose side on the x-axis is a group."""
    path = tmp_path / "square.msh"
    path.write_text("""$MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
2
1 7 "the wall"
2 1 "plate"
$EndPhysicalNames
$Nodes
4
1 0 0 0
2 1 0 0
3 1 1 0
4 0 1 0
$EndNodes
$Elements
3
1 1 2 7 1 1 2
2 2 2 1 1 1 2 3
3 2 2 1 1 1 3 4
$EndElements
""")
    return path
