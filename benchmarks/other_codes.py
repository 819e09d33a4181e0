#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The same work by polydec and by other codes that are installed: from the vertices and triangles
of a surface, in memory, to the stiffness matrix of functions, d^T star d. Each code has a process
and one thread of its own; its matrix is compared with polydec's, and one that differs is said to.

    benchmarks/other_codes.py                          a sphere of a million triangles
    benchmarks/other_codes.py --triangles 20000 --only scipy --only pydec
    benchmarks/other_codes.py --mesh bunny.off --json times.json
    benchmarks/other_codes.py --list                   what it knows, and what is installed

Needs the Python package of polydec: PYTHONPATH=build/release/python, or installed."""
import argparse
import importlib
import importlib.util
import json
import os
import resource
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import Callable, NamedTuple

TOLERANCE = 1e-10  # of the largest entry; rounding of another order of operations is 1e-14


def polydec(points, triangles):
    import polydec as code
    return code.discretize(code.Mesh(points, triangles), merge=False).stiffness(0)


def scipy(points, triangles):
    """What a careful user of numpy writes: sorted edges as numbers of 64 bits, unique ones,
    cotangents, and a triple product. unique(axis=0) would take several times as long."""
    import numpy as np
    from scipy.sparse import csr_matrix, diags
    sides = np.sort(triangles[:, [1, 2, 2, 0, 0, 1]].reshape(-1, 2), axis=1).astype("int64")
    keys, numbers = np.unique(sides[:, 0] * len(points) + sides[:, 1], return_inverse=True)
    edges = np.column_stack(np.divmod(keys, len(points)))
    a, b, c = (points[triangles[:, i]] for i in range(3))
    double_area = np.linalg.norm(np.cross(b - a, c - a), axis=1)
    cotangents = np.column_stack([np.einsum("ij,ij->i", q - p, r - p) / double_area
                                  for p, q, r in ((a, b, c), (b, c, a), (c, a, b))])
    star = np.bincount(numbers.ravel(), weights=cotangents.ravel() / 2)
    rows = np.repeat(np.arange(len(edges)), 2)
    d = csr_matrix((np.tile([-1.0, 1.0], len(edges)), (rows, edges.ravel())),
                   shape=(len(edges), len(points)))
    return d.T @ diags(star) @ d


def pydec(points, triangles):
    from pydec import simplicial_complex
    complex_ = simplicial_complex((points, triangles))
    return complex_[0].d.T @ complex_[1].star @ complex_[0].d


def igl(points, triangles):
    import igl as code
    return -code.cotmatrix(points, triangles)


def igl_arrays(points, triangles):
    return points, triangles.astype("int64")


def potpourri3d(points, triangles):
    import potpourri3d as code
    return code.cotan_laplacian(points, triangles, denom_eps=0.0)


def dolfin_mesh(points, triangles):
    """Is made vertex by vertex in Python, which is no matter of DOLFIN's."""
    import dolfin as code
    import numpy as np
    mesh, editor = code.Mesh(), code.MeshEditor()
    editor.open(mesh, "triangle", 2, points.shape[1])
    editor.init_vertices(len(points))
    editor.init_cells(len(triangles))
    for i, point in enumerate(points):
        editor.add_vertex(i, point)
    for i, triangle in enumerate(triangles):
        editor.add_cell(i, triangle.astype(np.uintp))
    editor.close(True)
    return (mesh,)


def dolfin(mesh):
    import dolfin as code
    from scipy.sparse import csr_matrix
    code.parameters["linear_algebra_backend"] = "Eigen"
    space = code.FunctionSpace(mesh, "P", 1)
    u, v = code.TrialFunction(space), code.TestFunction(space)
    matrix = code.as_backend_type(code.assemble(code.inner(code.grad(u), code.grad(v)) * code.dx))
    vertices = code.vertex_to_dof_map(space)
    return csr_matrix(matrix.sparray())[vertices][:, vertices]


class Code(NamedTuple):
    work: Callable  # from what it is given to the matrix; named as the module that it imports
    what: str
    how: str  # to install it
    given: Callable = lambda points, triangles: (points, triangles)  # made before the clock runs


CODES = {code.work.__name__: code for code in (
    Code(polydec, "complex, volumes, all stars; errors of all volumes",
         "build polydec with pybind11-dev"),
    Code(scipy, "edges by numpy.unique, cotangents, triple product",
         "apt-get install python3-scipy"),
    Code(pydec, "complex, volumes, all stars; triple product",
         "pip install . in a copy of hirani/pydec; the package index has another pydec"),
    Code(igl, "cotmatrix; no complex", "pip install libigl", igl_arrays),
    Code(potpourri3d, "cotan_laplacian; no complex", "pip install potpourri3d"),
    Code(dolfin, "P1 elements, assembled; its mesh is there; no complex",
         "apt-get install python3-dolfin", dolfin_mesh),
)}


def peak():
    """In bytes, so far. A process begins with the peak of that which starts it: that must be small,
    so what takes memory is done in processes of their own."""
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024


def measure(name, folder, options):
    """In a process of its own: runs the code, and compares its matrix with that of polydec."""
    import numpy as np
    from scipy.sparse import csr_matrix, load_npz, save_npz
    importlib.import_module(name)
    mesh = np.load(folder / "mesh.npz")
    count = len(mesh["triangles"])
    given = CODES[name].given(mesh["points"], mesh["triangles"])
    before, begin, seconds = peak(), time.perf_counter(), []
    while len(seconds) <= options.rounds:  # the first one is left out
        if seconds and time.perf_counter() - begin > options.seconds:
            break
        start = time.perf_counter()
        matrix = CODES[name].work(*given)
        seconds.append(time.perf_counter() - start)
    used = peak() - before
    matrix, reference = csr_matrix(matrix), folder / "matrix.npz"
    if name == "polydec":
        save_npz(reference, matrix)
    return {"seconds": seconds[1:] or seconds, "bytes": used / count,
            "difference": difference(matrix, load_npz(reference))}


def keep_mesh(folder, options):
    """In a process of its own: writes the mesh that all get, tells how large it is."""
    import numpy as np
    import polydec as code
    if options.mesh:
        mesh = code.read_mesh(options.mesh)
    else:
        mesh = code.meshes.icosphere(max(1, round((options.triangles / 20) ** 0.5)))
    if mesh.simplices.shape[1] != 3 or mesh.points.shape[1] != 3:
        raise ValueError(f"{options.mesh}: expected triangles in space")
    np.savez(folder / "mesh.npz", points=mesh.points, triangles=mesh.simplices)
    return {"triangles": len(mesh.simplices)}


def difference(matrix, right):
    """The largest, relative to the largest entry."""
    if matrix.shape != right.shape:
        return float("inf")
    return float(abs(matrix - right).max() / abs(right).max())


def verdict(off):
    return f"the same to {off:.0e}" if off <= TOLERANCE else f"DIFFERS by {off:.0e}"


def run(task, folder):
    """What a task, a code or `mesh`, answers from its process, or why it did not."""
    environment = dict(os.environ, OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1")
    answer = subprocess.run([sys.executable, "-B", __file__, *sys.argv[1:], "--task", task,
                             "--folder", folder], env=environment, capture_output=True, text=True)
    if answer.returncode:
        said = [line for line in answer.stderr.splitlines() if any(map(str.isalpha, line))]
        return {"failed": (said or [f"code {answer.returncode}"])[-1].strip("* ")}
    return json.loads(answer.stdout.splitlines()[-1])


def table(results):
    header = ["code", "minimum", "median", "rounds", "peak, bytes a triangle", "beside polydec",
              "matrix", "what"]
    rows = [header, ["---"] * len(header)]
    for name, found in results.items():
        if "failed" in found:
            cells = ["-", "-", "-", "-", "-", f"failed: {found['failed']}"]
        else:
            least = min(found["seconds"])
            cells = [f"{least:.3f} s", f"{statistics.median(found['seconds']):.3f} s",
                     str(len(found["seconds"])), f"{found['bytes']:,.0f}",
                     f"{least / min(results['polydec']['seconds']):.2f}",
                     "compared with" if name == "polydec" else verdict(found["difference"])]
        rows.append([name, *cells, CODES[name].what])
    return "\n".join("| " + " | ".join(row) + " |" for row in rows)


def chosen(only):
    """The codes that are asked for and installed; a line for each that is not."""
    asked = [name for name in CODES if not only or name in only or name == "polydec"]
    found = [name for name in asked if importlib.util.find_spec(name)]
    return found, [f"{name} is not installed and left out: {CODES[name].how}"
                   for name in asked if name not in found]


def arguments():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--mesh", type=Path, help="triangles in space, of any format of polydec")
    parser.add_argument("--triangles", type=int, default=1_000_000, help="of a sphere else")
    parser.add_argument("--only", action="append", choices=list(CODES), help="and polydec")
    parser.add_argument("--rounds", type=int, default=5, help="after a first one that is left out")
    parser.add_argument("--seconds", type=float, default=60,
                        help="no code begins another round after these")
    parser.add_argument("--json", type=Path, help="write what was measured")
    parser.add_argument("--list", action="store_true", help="the codes, and measure nothing")
    parser.add_argument("--task", choices=["mesh", *CODES], help=argparse.SUPPRESS)
    parser.add_argument("--folder", type=Path, help=argparse.SUPPRESS)
    return parser.parse_args()


def main():
    options = arguments()
    if options.rounds < 1 or options.triangles < 1:
        sys.exit("--rounds and --triangles: expected 1 or more")
    if options.task:
        print(json.dumps(keep_mesh(options.folder, options) if options.task == "mesh"
                         else measure(options.task, options.folder, options)))
        return
    names, left_out = chosen(options.only)
    if options.list:
        print("\n".join([f"{name}: {CODES[name].what}" for name in names] + left_out))
        return
    for line in left_out:
        print(line, file=sys.stderr)
    if "polydec" not in names:
        sys.exit("the Python package of polydec is not there: build it, and set "
                 "PYTHONPATH=build/release/python")
    load = os.getloadavg()[0]
    with tempfile.TemporaryDirectory() as folder:
        mesh, results = run("mesh", folder), {}
        for name in names if "failed" not in mesh else []:
            results[name] = run(name, folder)
            if "failed" in results["polydec"]:
                break
    failed = mesh.get("failed") or results["polydec"].get("failed")
    if failed:
        sys.exit(f"polydec: {failed}")
    print(f"{mesh['triangles']:,} triangles, one thread, load at the beginning {load:.1f}\n")
    print(table(results))
    if options.json:
        told = {**mesh, "load": load, "codes": results}
        options.json.write_text(json.dumps(told, indent=1) + "\n")


if __name__ == "__main__":
    main()
