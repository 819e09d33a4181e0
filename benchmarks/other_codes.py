#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The same work by polydec and by other codes that are installed: from the vertices and triangles
of a surface, in memory, to the stiffness matrix of functions, d^T star d. Each code has a process
and one thread of its own; its matrix is compared with polydec's, and one that differs is said to.

    benchmarks/other_codes.py                          a sphere of a million triangles
    benchmarks/other_codes.py --triangles 20000 --only polydec --only scipy
    benchmarks/other_codes.py --mesh bunny.off --json times.json

Needs the Python package of polydec: PYTHONPATH=build/release/python, or installed."""
import argparse
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

TOLERANCE = 1e-10  # of the largest entry; rounding of another order of operations is 1e-14


def polydec(points, triangles):
    import polydec as code
    return code.discretize(code.Mesh(points, triangles), merge=False).stiffness(0)


def scipy(points, triangles):
    """What one writes in numpy: sorted edges, unique ones, cotangents, and a triple product."""
    import numpy as np
    from scipy.sparse import csr_matrix, diags
    sides = np.sort(triangles[:, [1, 2, 2, 0, 0, 1]].reshape(-1, 2), axis=1)
    edges, numbers = np.unique(sides, axis=0, return_inverse=True)
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
    return complex_[0].d.T * complex_[1].star * complex_[0].d


def igl(points, triangles):
    import igl as code
    return -code.cotmatrix(points, triangles)


def potpourri3d(points, triangles):
    import potpourri3d as code
    return code.cotan_laplacian(points, triangles)


def dolfin(points, triangles):
    import dolfin as code
    import numpy as np
    from scipy.sparse import csr_matrix
    mesh, editor = code.Mesh(), code.MeshEditor()
    editor.open(mesh, "triangle", 2, points.shape[1])
    editor.init_vertices(len(points))
    editor.init_cells(len(triangles))
    for i, point in enumerate(points):
        editor.add_vertex(i, point)
    for i, triangle in enumerate(triangles):
        editor.add_cell(i, triangle.astype(np.uintp))
    editor.close(True)
    code.parameters["linear_algebra_backend"] = "Eigen"
    space = code.FunctionSpace(mesh, "P", 1)
    u, v = code.TrialFunction(space), code.TestFunction(space)
    matrix = code.as_backend_type(code.assemble(code.inner(code.grad(u), code.grad(v)) * code.dx))
    vertices = code.vertex_to_dof_map(space)
    return csr_matrix(matrix.sparray())[vertices][:, vertices]


# name, what it does, how to get it
CODES = [
    (polydec, "complex, volumes, stars; errors of all volumes", "build polydec with pybind11-dev"),
    (scipy, "numpy.unique, cotangents, triple product", "apt-get install python3-scipy"),
    (pydec, "simplicial_complex, triple product", "pip install pydec"),
    (igl, "cotmatrix; no complex", "pip install libigl"),
    (potpourri3d, "cotan_laplacian; no complex", "pip install potpourri3d"),
    (dolfin, "P1 elements, assembled; no complex", "apt-get install python3-dolfin"),
]
BY_NAME = {make.__name__: make for make, _, _ in CODES}


def work(name, mesh, rounds):
    """What runs in a process of its own: prints times and memory, and keeps the matrix."""
    import numpy as np
    from scipy.sparse import csr_matrix, save_npz
    given = np.load(mesh)
    points, triangles = given["points"], given["triangles"]
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    seconds = []
    for _ in range(rounds + 1):  # the first one loads the code
        begin = time.perf_counter()
        matrix = BY_NAME[name](points, triangles)
        seconds.append(time.perf_counter() - begin)
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before
    save_npz(mesh.with_name(f"{name}.npz"), csr_matrix(matrix))
    print(json.dumps({"seconds": seconds[1:], "bytes": peak * 1024 / len(triangles)}))


def difference(matrix, right):
    """The largest, relative to the largest entry."""
    if matrix.shape != right.shape:
        return float("inf")
    return float(abs(matrix - right).max() / abs(right).max())


def run(name, mesh, options):
    """What a code needed, or why it did not do it, and its matrix."""
    from scipy.sparse import load_npz
    environment = dict(os.environ, OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1")
    answer = subprocess.run([sys.executable, "-B", __file__, "--work", name, "--mesh", mesh,
                             "--rounds", str(options.rounds)], env=environment,
                            capture_output=True, text=True)
    if answer.returncode:
        said = [line for line in answer.stderr.splitlines() if any(map(str.isalpha, line))]
        return {"failed": (said or [f"code {answer.returncode}"])[-1].strip("* ")}, None
    return json.loads(answer.stdout.splitlines()[-1]), load_npz(mesh.with_name(f"{name}.npz"))


def table(results, what):
    lines = ["| code | minimum | median | peak, bytes a triangle | beside polydec | matrix | what |",
             "| --- | --- | --- | --- | --- | --- | --- |"]
    ours = min(results["polydec"]["seconds"])
    for name, found in results.items():
        if "failed" in found:
            lines.append(f"| {name} | - | - | - | - | failed: {found['failed']} | {what[name]} |")
            continue
        least, off = min(found["seconds"]), found["difference"]
        verdict = f"the same to {off:.0e}" if off <= TOLERANCE else f"DIFFERS by {off:.0e}"
        lines.append(f"| {name} | {least:.3f} s | {statistics.median(found['seconds']):.3f} s | "
                     f"{found['bytes']:,.0f} | {least / ours:.2f} | {verdict} | {what[name]} |")
    return "\n".join(lines)


def keep_mesh(options, path):
    """Writes the mesh that all get, and gives the number of its triangles."""
    import numpy as np
    import polydec as code
    if options.mesh:
        mesh = code.read_mesh(options.mesh)
    else:
        mesh = code.meshes.icosphere(max(1, round((options.triangles / 20) ** 0.5)))
    if mesh.simplices.shape[1] != 3 or mesh.points.shape[1] != 3:
        sys.exit(f"{options.mesh}: expected triangles in space")
    np.savez(path, points=mesh.points, triangles=mesh.simplices)
    return len(mesh.simplices)


def arguments():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--mesh", type=Path, help="triangles in space, of any format of polydec")
    parser.add_argument("--triangles", type=int, default=1_000_000, help="of a sphere else")
    parser.add_argument("--only", action="append", choices=list(BY_NAME), help="and polydec")
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--json", type=Path, help="write what was measured")
    parser.add_argument("--work", choices=list(BY_NAME), help=argparse.SUPPRESS)
    return parser.parse_args()


def main():
    options = arguments()
    if options.rounds < 1:
        sys.exit(f"--rounds is {options.rounds}: expected 1 or more")
    if options.work:
        return work(options.work, options.mesh, options.rounds)
    if not importlib.util.find_spec("polydec"):
        sys.exit("the Python package of polydec is not there: build it, and set "
                 "PYTHONPATH=build/release/python")
    results, right = {}, None
    with tempfile.TemporaryDirectory() as folder:
        mesh = Path(folder) / "mesh.npz"
        count = keep_mesh(options, mesh)
        for make, _, how in CODES:
            name = make.__name__
            if options.only and name not in options.only and name != "polydec":
                continue
            if not importlib.util.find_spec(name):
                print(f"{name} is left out: {how}", file=sys.stderr)
                continue
            results[name], matrix = run(name, mesh, options)
            if name == "polydec" and matrix is None:
                sys.exit(f"polydec: {results[name]['failed']}")
            right = matrix if right is None else right
            if matrix is not None:
                results[name]["difference"] = difference(matrix, right)
    print(f"{count:,} triangles, one thread, {options.rounds} rounds\n")
    print(table(results, {make.__name__: what for make, what, _ in CODES}))
    if options.json:
        options.json.write_text(json.dumps(results, indent=1) + "\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())
